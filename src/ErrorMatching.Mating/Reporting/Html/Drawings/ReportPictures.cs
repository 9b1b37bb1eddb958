using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the plot of the mating errors and the drawings of the assembly.</summary>
internal static class ReportPictures
{
    /// <summary>Writes the section.</summary>
    /// <param name="html">The output.</param>
    /// <param name="points">The key points in the order of cutting.</param>
    /// <param name="scene">The assembly; null if there is nothing to draw.</param>
    /// <param name="before">Legend for the values without compensation.</param>
    /// <param name="after">Legend for the values with compensation.</param>
    /// <param name="between">The worst places between the key points.</param>
    public static void Write(
        HtmlText html,
        IReadOnlyList<PlotPoint> points,
        AssemblyScene? scene,
        string before,
        string after,
        IReadOnlyList<PlotPlace>? between = null)
    {
        if (scene is not null)
        {
            WriteAssembly(html, scene, before, after);
        }

        if (points.Count > 0)
        {
            using (html.In("figure"))
            {
                using (Scroll(html, "Plot of the mating errors"))
                {
                    new ErrorPlot(points, between).Write(html, "plot", before, after);
                }

                html.Put(
                    "figcaption",
                    "Mating error (counterpart - part, along the normal) at each key point: positive where the pieces overlap, negative "
                        + "where a gap is left."
                    + (
                        points.Any(p => p.Interval95Mm is not null)
                            ? " A vertical bar is the 95 % interval of what is left over."
                            : "")
                    + (
                        between is { Count: > 0 }
                            ? " A cross is the largest error expected between the key points of a feature; the ring marks the "
                                + "worst."
                            : "")
                    + (
                        points.Any(p => p.Limits is not null)
                            ? " The shaded band is the tolerance, seen as a mating error: a part that lies high in its band leaves a gap."
                            : ""));
            }
        }
    }

    private static void WriteAssembly(HtmlText html, AssemblyScene scene, string before, string after)
    {
        using (html.In("figure"))
        {
            using (Scroll(html, "Drawings of the assembly"))
            using (html.In("div", ("class", "pair")))
            {
                new AssemblyDrawing(scene, p => p.Before).Write(html, "drawing-before", before);
                new AssemblyDrawing(scene, p => p.After).Write(html, "drawing-after", after);
            }

            html.Put(
                "figcaption",
                (scene.Factor == 1 ? "The assembly, true to scale." : $"The assembly, with deviations exaggerated {scene.FactorText}.")
                + " A blank between the pieces is a gap; where the edges lie over each other the pieces would overlap. Deviations are "
                    + "known at the key points (dots) and drawn evenly between them.");
        }
    }

    private static HtmlScope Scroll(HtmlText html, string label) =>
        html.In("div", ("class", "scroll"), ("role", "region"), ("tabindex", "0"), ("aria-label", label));
}
