namespace ErrorMatching.Reporting;

/// <summary>The area and the axes of a plot of values over points. Lengths are in pixels.</summary>
/// <param name="axis">The vertical axis.</param>
/// <param name="labels">The labels of the points, from left to right.</param>
public sealed class PointPlot(PlotAxis axis, IReadOnlyList<string> labels)
{
    // More labels than this would overlap, even short ones.
    private const int MostLabels = 30;

    private const int LongestLabel = 6;
    private const double CharacterWidth = 7, LabelGap = 6;

    /// <summary>Size of the drawing.</summary>
    public required (double Width, double Height) Size { get; init; }

    /// <summary>Left end of the area.</summary>
    public required double Left { get; init; }

    /// <summary>Right end of the area.</summary>
    public required double Right { get; init; }

    /// <summary>Top of the area, the highest value.</summary>
    public required double Top { get; init; }

    /// <summary>Bottom of the area, the lowest value.</summary>
    public required double Bottom { get; init; }

    /// <summary>Horizontal center of the area.</summary>
    public double Middle => (Left + Right) / 2;

    /// <summary>Horizontal position of a point; half an index further is the border to the next one.</summary>
    public double X(double index) => Left + ((index + 0.5) * (Right - Left) / labels.Count);

    /// <summary>Vertical position of a value.</summary>
    public double Y(double value) => Bottom - ((value - axis.Lowest) / (axis.Highest - axis.Lowest) * (Bottom - Top));

    /// <summary>Writes the grid with the numbers of the vertical axis.</summary>
    /// <param name="html">The output.</param>
    /// <param name="number">The text for a value.</param>
    public void WriteGrid(HtmlText html, Func<double, string> number)
    {
        ArgumentNullException.ThrowIfNull(number);
        for (var tick = axis.First; tick <= axis.Last; tick++)
        {
            var y = Y(tick * axis.Step);
            SvgShapes.Line(html, tick == 0 ? "zero" : "grid", Left, y, Right, y);
            SvgShapes.Text(html, "tick", Left - 8, y + 4, "end", number(tick * axis.Step));
        }
    }

    /// <summary>Writes the labels of the points, as many as there is space for, the vertical axis, and the titles of both axes.</summary>
    /// <param name="html">The output.</param>
    /// <param name="points">Title of the points.</param>
    /// <param name="pointsBelow">Distance of that title from the bottom of the drawing.</param>
    /// <param name="values">Title of the values.</param>
    public void WriteAxes(HtmlText html, string points, double pointsBelow, string values)
    {
        ArgumentNullException.ThrowIfNull(html);
        var longest = labels.Select(l => Math.Min(l.Length, LongestLabel)).DefaultIfEmpty().Max();
        var needed = labels.Count * ((longest * CharacterWidth) + LabelGap) / (Right - Left);
        var every = Math.Max((labels.Count + MostLabels - 1) / MostLabels, (int)Math.Ceiling(needed));
        for (var i = 0; i < labels.Count; i += every)
        {
            SvgShapes.Text(html, "tick", X(i), Bottom + 18, "middle", SvgNumber.Label(labels[i], LongestLabel));
        }

        SvgShapes.Line(html, "axis", Left, Top, Left, Bottom);
        SvgShapes.Text(html, "axis-label", Middle, Size.Height - pointsBelow, "middle", points);
        using (html.In(
            "text",
            ("class", "axis-label"),
            ("text-anchor", "middle"),
            ("transform", $"translate(16 {SvgNumber.Of((Top + Bottom) / 2)}) rotate(-90)")))
        {
            html.Text(values);
        }
    }
}
