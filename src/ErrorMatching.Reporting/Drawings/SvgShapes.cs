namespace ErrorMatching.Reporting;

/// <summary>Writes the parts that drawings have in common: the frame, lines, texts and markers. Lengths are in pixels.</summary>
public static class SvgShapes
{
    /// <summary>Opens a drawing with a title and a description for screen readers; disposing of the result closes it.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="cssClass">Its class.</param>
    /// <param name="size">Its width and height.</param>
    /// <param name="title">Its title.</param>
    /// <param name="description">What it shows, in words.</param>
    public static HtmlScope Drawing(
        HtmlText html, string id, string cssClass, (double Width, double Height) size, string title, string description)
    {
        ArgumentNullException.ThrowIfNull(html);
        var drawing = html.In(
            "svg",
            ("viewBox", $"0 0 {SvgNumber.Of(size.Width)} {SvgNumber.Of(size.Height)}"),
            ("role", "img"),
            ("aria-labelledby", $"{id}-t {id}-d"),
            ("class", cssClass));
        html.Put("title", title, ("id", id + "-t"));
        html.Put("desc", description, ("id", id + "-d"));
        return drawing;
    }

    /// <summary>Writes a straight line.</summary>
    public static void Line(HtmlText html, string cssClass, double x1, double y1, double x2, double y2)
    {
        ArgumentNullException.ThrowIfNull(html);
        html.Empty(
            "line",
            ("class", cssClass),
            ("x1", SvgNumber.Of(x1)),
            ("y1", SvgNumber.Of(y1)),
            ("x2", SvgNumber.Of(x2)),
            ("y2", SvgNumber.Of(y2)));
    }

    /// <summary>Writes a text on its baseline.</summary>
    /// <param name="html">The output.</param>
    /// <param name="cssClass">Its class.</param>
    /// <param name="x">Position of the anchor.</param>
    /// <param name="y">Position of the baseline.</param>
    /// <param name="anchor">What is at the position: <c>start</c>, <c>middle</c> or <c>end</c>.</param>
    /// <param name="text">The text.</param>
    public static void Text(HtmlText html, string cssClass, double x, double y, string anchor, string text)
    {
        ArgumentNullException.ThrowIfNull(html);
        html.Put("text", text, ("class", cssClass), ("x", SvgNumber.Of(x)), ("y", SvgNumber.Of(y)), ("text-anchor", anchor));
    }

    /// <summary>Writes a circle with a tooltip; without a tooltip, it is an empty element.</summary>
    public static void Circle(HtmlText html, string cssClass, double x, double y, double radius, string? title)
    {
        ArgumentNullException.ThrowIfNull(html);
        var (cx, cy, r) = (SvgNumber.Of(x), SvgNumber.Of(y), SvgNumber.Of(radius));
        if (title is null)
        {
            html.Empty("circle", ("class", cssClass), ("cx", cx), ("cy", cy), ("r", r));
            return;
        }

        using (html.In("circle", ("class", cssClass), ("cx", cx), ("cy", cy), ("r", r)))
        {
            html.Put("title", title);
        }
    }

    /// <summary>Writes a square on its corner with a tooltip.</summary>
    public static void Diamond(HtmlText html, string cssClass, double x, double y, string title)
    {
        ArgumentNullException.ThrowIfNull(html);
        using (html.In("polygon", ("class", cssClass), ("points", SvgNumber.Points([(x, y - 5), (x + 5, y), (x, y + 5), (x - 5, y)]))))
        {
            html.Put("title", title);
        }
    }

    /// <summary>Writes a vertical bar with a short line across each end.</summary>
    public static void Bar(HtmlText html, string cssClass, double x, double y1, double y2)
    {
        ArgumentNullException.ThrowIfNull(html);
        const double half = 3;
        html.Empty(
            "path",
            ("class", cssClass),
            (
                "d",
                $"M{SvgNumber.Point(x, y1)}L{SvgNumber.Point(x, y2)}M{SvgNumber.Point(x - half, y1)}"
                    + $"L{SvgNumber.Point(x + half, y1)}M{SvgNumber.Point(x - half, y2)}L{SvgNumber.Point(x + half, y2)}"));
    }

    /// <summary>Writes a plus sign with a tooltip.</summary>
    public static void Plus(HtmlText html, string cssClass, double x, double y, string title)
    {
        ArgumentNullException.ThrowIfNull(html);
        var (left, right) = (SvgNumber.Point(x - 5, y), SvgNumber.Point(x + 5, y));
        var (above, below) = (SvgNumber.Point(x, y - 5), SvgNumber.Point(x, y + 5));
        using (html.In("path", ("class", cssClass), ("d", $"M{left}L{right}M{above}L{below}")))
        {
            html.Put("title", title);
        }
    }
}
