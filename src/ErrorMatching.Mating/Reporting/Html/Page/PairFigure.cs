using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The picture of a pair, assembled.</summary>
internal static class PairFigure
{
    /// <summary>Writes the picture with its caption.</summary>
    /// <param name="html">The output.</param>
    /// <param name="pair">The pair.</param>
    /// <param name="counterpart">The counterpart in words: "the counterpart as measured".</param>
    public static void Write(HtmlText html, PairAssembly pair, string counterpart)
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
                    ? $"The part pressed home into {counterpart}."
                    : $"The part where it has the most air at the tightest place of {counterpart}.")
                + " A dot is where they touch, or where the air is least."
                + (PairWords.Play(pair) is { } play ? " " + play : ""));
        }
    }
}
