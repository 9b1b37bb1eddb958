using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Finds room for the box with the values of the selected datum.</summary>
/// <param name="within">Size of the area for the box, from the upper left corner of the plot.</param>
/// <param name="at">The datum, in screen units.</param>
/// <param name="isOverLine">Checks whether a box would hide a line of the drawing.</param>
/// <param name="isOverDatum">Checks whether a box would hide the datum.</param>
internal sealed class ValuesBox(Size within, Point at, Func<Rect, bool> isOverLine, Func<Rect, bool> isOverDatum)
{
    /// <summary>The text to show and the place of its box.</summary>
    /// <param name="texts">The same values in shapes to choose from, the best first. The last one is used if none fits.</param>
    public (FormattedText Text, Rect Box) Place(IReadOnlyList<FormattedText> texts)
    {
        var fitting = texts.Where(t => SizeOf(t).Width <= within.Width).ToArray();
        var rooms = fitting.Select(t => (Text: t, Box: FreeRoom(SizeOf(t))))
            .Concat(fitting.Select(t => (Text: t, Box: Corner(SizeOf(t)))))
            .Append((Text: texts[^1], Box: FarCorner(SizeOf(texts[^1]))));
        return rooms.Where(r => r.Box is not null).Select(r => (r.Text, r.Box!.Value)).First();
    }

    private static Size SizeOf(FormattedText text) => new(text.Width + (2 * DrawnSizes.Around), text.Height + (2 * DrawnSizes.Around));

    // A position next to the datum, nearest first, or else in a corner, where the box hides no line.
    private Rect? FreeRoom(Size size)
    {
        var (right, low) = RoomsEnd(size);
        var beside = DrawnSizes.BoxAway.SelectMany(a => new[] { (1, -1), (-1, -1), (1, 1), (-1, 1) }.Select(s => new Point(
            s.Item1 > 0 ? at.X + a : at.X - a - size.Width,
            s.Item2 > 0 ? at.Y + a : at.Y - a - size.Height))).Where(p => p.X >= 0 && p.X <= right && p.Y >= 0 && p.Y <= low);
        var places = beside.Concat(Corners(size)).Select(p => new Rect(p, size)).ToArray();
        return Array.Find(places, p => !p.Contains(at) && !isOverLine(p)) is { Width: > 0 } free ? free : null;
    }

    // If there is no such position: the farthest corner that does not hide the marked item.
    private Rect? Corner(Size size) => Corners(size).Select(c => new Rect(c, size))
        .Where(c => !isOverDatum(c))
        .OrderByDescending(c => Point.Distance(c.Center, at))
        .Select(c => (Rect?)c)
        .FirstOrDefault();

    private Rect? FarCorner(Size size) => Corners(size).Select(c => new Rect(c, size)).MaxBy(c => Point.Distance(c.Center, at));

    private Point[] Corners(Size size) =>
        RoomsEnd(size) is var (right, low) ? [new(0, 0), new(0, low), new(right, low), new(right, 0)] : [];

    private (double Right, double Low) RoomsEnd(Size size) =>
        (Math.Max(0, within.Width - size.Width), Math.Max(0, within.Height - size.Height));
}
