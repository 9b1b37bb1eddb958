using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Places labels next to their points: never over another label, over dots and lines only if necessary.</summary>
/// <remarks>A label that could be mistaken for another dot's is moved away and gets a leader line. A label without room is left
/// out; it appears when the user zooms in.</remarks>
internal sealed class PlotLabels
{
    // Limit for checking every line for every position of every label. Below it, a person can still read the labels.
    private const int MostLooks = 200_000;
    private const int Sides = 8;

    // The first two positions of a label that is not a name: right and left.
    private const int Beside = 2;

    // Covering a dot costs as much as covering this many lines. So does a position where the label may be mistaken for another dot's.
    private const int LinesADot = 10;

    // A label at a corner is shifted less along each axis, so that its distance is the same.
    private const double SlantShare = 0.6;

    // Another dot must be farther from a label than its own dot by this factor, or the label may be mistaken for the other's.
    private const double PlainlyFurtherFactor = 1.5;

    // Distance of a label that does not fit next to its place, in multiples of the normal distance.
    private const double FarFactor = 3, FurthestFactor = 5;
    private static readonly double[] Further = [FarFactor, FurthestFactor];

    private readonly (Point From, Point To)[] _lines;
    private readonly Point[] _dots;
    private readonly double _dot;
    private readonly Rect _within;
    private readonly List<Rect> _taken = [];
    private readonly List<(Point From, Point To)> _leaders = [];

    /// <summary>Free room for labels.</summary>
    /// <param name="lines">The drawing, as polylines in screen units.</param>
    /// <param name="places">Places that have a label, in screen units.</param>
    /// <param name="dot">Radius of the dots at the places.</param>
    /// <param name="within">Area for labels that are moved away from their places.</param>
    public PlotLabels(IEnumerable<IReadOnlyList<Point>> lines, IReadOnlyCollection<Point> places, double dot, Rect within)
    {
        (_dots, _dot, _within) = ([.. places], dot, within);
        var segments = lines.SelectMany(l => l.Zip(l.Skip(1))).ToArray();
        _lines = (long)segments.Length * Sides * _dots.Length <= MostLooks ? segments : [];
    }

    /// <summary>The position of a label; null if there is no room.</summary>
    /// <param name="text">The label.</param>
    /// <param name="at">The place that it belongs to.</param>
    /// <param name="away">Distance between the two.</param>
    /// <param name="isName">True for the name of several dots: above or below is better than beside, and other dots may be near.</param>
    /// <param name="isSpare">True if the label is left out unless it fits next to its place without covering anything.</param>
    public LabelRoom? Place(FormattedText text, Point at, double away, bool isName = false, bool isSpare = false)
    {
        // An optional label must be level with its place, or it may be mistaken for a neighbor's.
        var around = Around(text, at, away, isName);
        var best = Best(isSpare ? around.Take(Beside) : around, at, isName, isAway: false);
        foreach (var further in Further.TakeWhile(_ => !isSpare && best is not { Cost: < LinesADot }))
        {
            best = Best(Around(text, at, further * away, isName).Where(_within.Contains), at, isName, isAway: true) is { } found
                && !(found.Cost >= best?.Cost)
                ? found
                : best;
        }

        if (best is not var (room, isAway, cost) || (isSpare && cost > 0))
        {
            return null;
        }

        _taken.Add(room.Inflate(new Thickness(DrawnSizes.Near, 0)));
        if (!isAway)
        {
            return new(room.TopLeft, null);
        }

        var leader = (at, NearestOf(room, at));
        _leaders.Add(leader);
        return new(room.TopLeft, leader);
    }

    private static Rect[] Around(FormattedText text, Point at, double away, bool isBelow)
    {
        var (w, h) = (text.Width, text.Height);
        var (right, left, above, below, slant) = (at.X + away, at.X - away - w, at.Y - away - h, at.Y + away, SlantShare * away);
        Rect[] beside = [new(right, at.Y - (h / 2), w, h), new(left, at.Y - (h / 2), w, h)];
        Rect[] over = [new(at.X - (w / 2), above, w, h), new(at.X - (w / 2), below, w, h)];
        Rect[] corners = [
            new(at.X + slant, at.Y - slant - h, w, h),
            new(at.X - slant - w, at.Y - slant - h, w, h),
            new(at.X + slant, at.Y + slant, w, h),
            new(at.X - slant - w, at.Y + slant, w, h)];
        return isBelow ? [.. over.Reverse(), .. corners, .. beside] : [.. beside, .. over, .. corners];
    }

    // Of equally good positions, the first one.
    private (Rect Room, bool IsAway, int Cost)? Best(IEnumerable<Rect> rooms, Point at, bool isName, bool isAway)
    {
        var free = rooms.Where(
            r => !_leaders.Exists(l => Crosses(l, r))
                && !_taken.Exists(t => t.Intersects(r) || (isAway && Crosses((at, NearestOf(r, at)), t))))
            .Select(r => (Room: r, IsAway: isAway, Cost: CostOf(r, at, isName, isAway)))
            .ToArray();
        return free.Length == 0 ? null : free.MinBy(r => r.Cost);
    }

    // What the label covers, how many dots it may be mistaken for, and what its leader line crosses. Next to its own dot there is
    // no leader line.
    private int CostOf(Rect room, Point at, bool isName, bool isAway)
    {
        var (own, covered, leader) = (
            PlainlyFurtherFactor * Point.Distance(at, NearestOf(room, at)), room.Inflate(_dot), (at, NearestOf(room, at)));
        var dots = _dots.Count(
            d => covered.Contains(d)
                || (
                    d != at
                        && (
                            isAway
                                ? Crosses(leader, new Rect(d, default(Size)).Inflate(_dot))
                                : !isName && Point.Distance(d, NearestOf(room, d)) < own)));
        return (LinesADot * dots) + _lines.Count(l => Crosses(l, room));
    }

    private static Point NearestOf(Rect room, Point to) =>
        new(Math.Clamp(to.X, room.Left, room.Right), Math.Clamp(to.Y, room.Top, room.Bottom));

    // Liang and Barsky 1984: the part of the line between the four borders is not empty.
    private static bool Crosses((Point From, Point To) line, Rect room)
    {
        var (dx, dy, begin, end) = (line.To.X - line.From.X, line.To.Y - line.From.Y, 0.0, 1.0);
        return Cut(-dx, line.From.X - room.Left)
            && Cut(dx, room.Right - line.From.X)
            && Cut(-dy, line.From.Y - room.Top)
            && Cut(dy, room.Bottom - line.From.Y);

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

/// <summary>Position of a label, in screen units.</summary>
/// <param name="Corner">Its upper left corner.</param>
/// <param name="Leader">Leader line from the marked place to the label; null if the label is next to its place.</param>
internal readonly record struct LabelRoom(Point Corner, (Point From, Point To)? Leader);
