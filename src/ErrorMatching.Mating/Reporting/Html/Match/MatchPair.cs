using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the picture of the pair, assembled.</summary>
internal static class MatchPair
{
    public static void Write(HtmlText html, PairAssembly pair)
    {
        using (html.In("figure"))
        {
            using (html.In(
                "div", ("class", "scroll"), ("role", "region"), ("tabindex", "0"), ("aria-label", "Drawing of the pair, assembled")))
            {
                new PairDrawing(pair).Write(html, "drawing-pair");
            }

            html.Put(
                "figcaption",
                (pair.TightestMm is null
                    ? "The part pressed home into the counterpart that the program will cut."
                    : "The part where it has the most air at the tightest place of the counterpart that the program will cut.")
                + " A dot is where they touch, or where the air is least."
                + (PairWords.Play(pair) is { } play ? " " + play : ""));
        }
    }
}
