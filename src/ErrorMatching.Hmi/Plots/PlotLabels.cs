using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Finds room for labels beside their places: never over another label, and over dots and lines only where there is no other way.</summary>
/// <remarks>A label that would belong to another dot as well stands away, at the end of a line that leads to it. One that finds no room is left out; it appears when one goes nearer.</remarks>
internal sealed class PlotLabels
{
    // Looking at every line for every side of every label is worth it while a person can read the labels.
    private const int MostLooks = 200_000;
    private const int Sides = 8;

    // The first of them, but for a name: to the right and to the left.
    private const int Beside = 2;

    // A dot that is covered is as bad as so many lines, and so is one that the label may be taken for.
    private const int LinesADot = 10;

    // A label at a corner is nearer along each side, as far away in all.
    private const double SlantShare = 0.6;

    // Another dot is so many times as far from a label as its own, or the label may be taken for it.
    private const double PlainlyFurtherFactor = 1.5;

    // How far a label stands away where it cannot stand beside its place, in multiples of that.
    private const double FarFactor = 3, FurthestFactor = 5;
    private static readonly double[] Further = [FarFactor, FurthestFactor];

    private readonly (Point From, Point To)[] _lines;
    private readonly Point[] _dots;
    private readonly double _dot;
    private readonly Rect _within;
    private readonly List<Rect> _taken = [];
    private readonly List<(Point From, Point To)> _leaders = [];

    /// <summary>Room that nothing takes yet.</summary>
    /// <param name="lines">What is drawn, as polylines in units of the screen.</param>
    /// <param name="places">What has a label, in units of the screen.</param>
    /// <param name="dot">Radius of the dots at the places.</param>
    /// <param name="within">Where a label may stand that stands away from its place.</param>
    public PlotLabels(IEnumerable<IReadOnlyList<Point>> lines, IReadOnlyCollection<Point> places, double dot, Rect within)
    {
        (_dots, _dot, _within) = ([.. places], dot, within);
        var segments = lines.SelectMany(l => l.Zip(l.Skip(1))).ToArray();
        _lines = (long)segments.Length * Sides * _dots.Length <= MostLooks ? segments : [];
    }

    /// <summary>The room of a label; null if it finds none.</summary>
    /// <param name="text">The label.</param>
    /// <param name="at">What it belongs to.</param>
    /// <param name="away">How far from it.</param>
    /// <param name="isName">True for a name of more than one dot: it had rather be below or above than beside, and it may be near others.</param>
    /// <param name="isSpare">True if it stands beside its place over nothing else, or is left out.</param>
    public LabelRoom? Place(FormattedText text, Point at, double away, bool isName = false, bool isSpare = false)
    {
        // One that may be left out stands at the height of its own place, or it is taken for a neighbor's.
        var around = Around(text, at, away, isName);
        var best = Best(isSpare ? around.Take(Beside) : around, at, isName, isAway: false);
        foreach (var further in Further.TakeWhile(_ => !isSpare && best is not { Cost: < LinesADot }))
        {
            best = Best(Around(text, at, further * away, isName).Where(_within.Contains), at, isName, isAway: true) is { } found && !(found.Cost >= best?.Cost) ? found : best;
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
        Rect[] corners = [new(at.X + slant, at.Y - slant - h, w, h), new(at.X - slant - w, at.Y - slant - h, w, h), new(at.X + slant, at.Y + slant, w, h), new(at.X - slant - w, at.Y + slant, w, h)];
        return isBelow ? [.. over.Reverse(), .. corners, .. beside] : [.. beside, .. over, .. corners];
    }

    // Of several that are as good the first one.
    private (Rect Room, bool IsAway, int Cost)? Best(IEnumerable<Rect> rooms, Point at, bool isName, bool isAway)
    {
        var free = rooms.Where(r => !_leaders.Exists(l => Crosses(l, r)) && !_taken.Exists(t => t.Intersects(r) || (isAway && Crosses((at, NearestOf(r, at)), t)))).Select(r => (Room: r, IsAway: isAway, Cost: CostOf(r, at, isName, isAway))).ToArray();
        return free.Length == 0 ? null : free.MinBy(r => r.Cost);
    }

    // What is covered or may be meant, and what a line that leads to the label crosses besides; beside its own dot it crosses nothing that was not there.
    private int CostOf(Rect room, Point at, bool isName, bool isAway)
    {
        var (own, covered, leader) = (PlainlyFurtherFactor * Point.Distance(at, NearestOf(room, at)), room.Inflate(_dot), (at, NearestOf(room, at)));
        var dots = _dots.Count(d => covered.Contains(d) || (d != at && (isAway ? Crosses(leader, new Rect(d, default(Size)).Inflate(_dot)) : !isName && Point.Distance(d, NearestOf(room, d)) < own)));
        return (LinesADot * dots) + _lines.Count(l => Crosses(l, room));
    }

    private static Point NearestOf(Rect room, Point to) => new(Math.Clamp(to.X, room.Left, room.Right), Math.Clamp(to.Y, room.Top, room.Bottom));

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
