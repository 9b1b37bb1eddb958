using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Finds room for labels beside their places: never over another label, and over dots and lines only where there is no other way.</summary>
/// <remarks>A label that finds no room is left out; it appears when one goes nearer.</remarks>
internal sealed class PlotLabels
{
    // Looking at every line for every side of every label is worth it while a person can read the labels.
    private const int MostLooks = 200_000;
    private const int Sides = 8;

    // A dot that is covered is as bad as so many lines.
    private const int LinesADot = 10;

    // A label at a corner is nearer along each side, as far away in all.
    private const double SlantShare = 0.6;
    private readonly (Point From, Point To)[] _lines;
    private readonly Point[] _dots;
    private readonly double _dot;
    private readonly List<Rect> _taken = [];

    /// <summary>Room that nothing takes yet.</summary>
    /// <param name="lines">What is drawn, as polylines in units of the screen.</param>
    /// <param name="places">What has a label, in units of the screen.</param>
    /// <param name="dot">Radius of the dots at the places.</param>
    public PlotLabels(IEnumerable<IReadOnlyList<Point>> lines, IReadOnlyCollection<Point> places, double dot)
    {
        (_dots, _dot) = ([.. places], dot);
        var segments = lines.SelectMany(l => l.Zip(l.Skip(1))).ToArray();
        _lines = (long)segments.Length * Sides * _dots.Length <= MostLooks ? segments : [];
    }

    /// <summary>The left upper corner of a label; null if it finds no room.</summary>
    /// <param name="text">The label.</param>
    /// <param name="at">What it belongs to.</param>
    /// <param name="away">How far from it.</param>
    /// <param name="isBelow">True if it had rather be below or above than beside.</param>
    public Point? Place(FormattedText text, Point at, double away, bool isBelow = false)
    {
        var (w, h) = (text.Width, text.Height);
        var (right, left, above, below, slant) = (at.X + away, at.X - away - w, at.Y - away - h, at.Y + away, SlantShare * away);
        Rect[] beside = [new(right, at.Y - (h / 2), w, h), new(left, at.Y - (h / 2), w, h)];
        Rect[] over = [new(at.X - (w / 2), above, w, h), new(at.X - (w / 2), below, w, h)];
        Rect[] corners = [new(at.X + slant, at.Y - slant - h, w, h), new(at.X - slant - w, at.Y - slant - h, w, h), new(at.X + slant, at.Y + slant, w, h), new(at.X - slant - w, at.Y + slant, w, h)];
        Rect[] sides = isBelow ? [.. over.Reverse(), .. corners, .. beside] : [.. beside, .. over, .. corners];
        var free = sides.Where(s => !_taken.Exists(t => t.Intersects(s))).ToArray();
        if (free.Length == 0)
        {
            return null;
        }

        var best = free.MinBy(s => (LinesADot * _dots.Count(d => s.Inflate(_dot).Contains(d))) + _lines.Count(l => Crosses(l, s)));
        _taken.Add(best.Inflate(new Thickness(DrawnSizes.VeilBeside, 0)));
        return best.TopLeft;
    }

    // Liang and Barsky 1984: the part of the line within the four borders is not empty.
    private static bool Crosses((Point From, Point To) line, Rect room)
    {
        var (dx, dy, begin, end) = (line.To.X - line.From.X, line.To.Y - line.From.Y, 0.0, 1.0);
        return Cut(-dx, line.From.X - room.Left) && Cut(dx, room.Right - line.From.X) && Cut(-dy, line.From.Y - room.Top) && Cut(dy, room.Bottom - line.From.Y);

        bool Cut(double outward, double inside)
        {
            if (outward == 0)
            {
                return inside >= 0;
            }

            var share = inside / outward;
            (begin, end) = outward < 0 ? (Math.Max(begin, share), end) : (begin, Math.Min(end, share));
            return begin <= end;
        }
    }
}
