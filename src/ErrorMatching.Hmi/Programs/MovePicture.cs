using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>The path of a program projected onto its working plane. It can draw a view, and find the move under a finger, without
/// visiting all of a million moves.</summary>
/// <remarks>Consecutive moves are close to each other in space. So bounding boxes around 16 moves, around 8 such boxes, and so
/// on, form a tree. A box smaller than a pixel is drawn as one dot.</remarks>
public sealed class MovePicture
{
    private const int Leaf = 16, Branch = 8, MostChords = 4096;

    // Largest distance of chords from an arc, in pixels. Share of the reach that a rapid must be nearer than a cut to be selected.
    private const double ChordError = 0.25, RapidPenalty = 0.25;

    private readonly NcMotions _motions;
    private readonly CoordinatePlane _plane;
    private readonly AxisSet _axes;
    private readonly Point2[] _ends;
    private readonly Kind[] _kinds;
    private readonly PlotBox[][] _boxes;
    private readonly bool[][] _cuts;

    /// <summary>Creates the picture of a path.</summary>
    public MovePicture(NcPath path)
    {
        ArgumentNullException.ThrowIfNull(path);
        _motions = path.Motions;
        _plane = path.Motions.FirstOrDefault(m => m.IsCut).Plane;
        _axes = _plane switch
        {
            CoordinatePlane.ZX => AxisSet.Z | AxisSet.X,
            CoordinatePlane.YZ => AxisSet.Y | AxisSet.Z,
            _ => AxisSet.X | AxisSet.Y
        };
        var count = _motions.Length;
        (_ends, _kinds) = (new Point2[count], new Kind[count]);
        var (boxes, cuts) = (new PlotBox[(count + Leaf - 1) / Leaf], new bool[(count + Leaf - 1) / Leaf]);
        Array.Fill(boxes, PlotBox.Empty);
        for (var i = 0; i < count; i++)
        {
            var motion = _motions[i];
            _ends[i] = _plane.Project(motion.End);
            _kinds[i] = KindOf(motion, i == 0 ? null : _ends[i - 1]);
            if (!Is(i, Kind.Unknown))
            {
                boxes[i / Leaf] = boxes[i / Leaf].With(BoxOf(i, motion));
                cuts[i / Leaf] |= !Is(i, Kind.Rapid);
            }
        }

        var (levels, flags) = (new List<PlotBox[]> { boxes }, new List<bool[]> { cuts });
        while (levels[^1].Length > 1)
        {
            levels.Add([.. levels[^1].Chunk(Branch).Select(c => c.Aggregate((a, b) => a.With(b)))]);
            flags.Add([.. flags[^1].Chunk(Branch).Select(c => c.Contains(true))]);
        }

        (_boxes, _cuts) = ([.. levels], [.. flags]);
        Extent = count == 0 ? PlotBox.Empty : levels[^1][0];
    }

    [Flags]
    private enum Kind : byte
    {
        Straight = 0,
        Rapid = 1,
        Arc = 2,
        StartsElsewhere = 4,
        Unknown = 8,
    }

    /// <summary>The plane of projection.</summary>
    public CoordinatePlane Plane => _plane;

    /// <summary>The bounding box of the path, mm.</summary>
    public PlotBox Extent { get; }

    /// <summary>Number of motions, including those that are not drawn because only the machine knows where they lead.</summary>
    public int Count => _ends.Length;

    /// <summary>Visits the visible strokes of the path, in program order.</summary>
    /// <param name="view">The visible part.</param>
    /// <param name="pixel">Size of a pixel in screen units.</param>
    /// <param name="draw">Called for each stroke; returns false to stop.</param>
    /// <returns>False if it was stopped.</returns>
    public bool Strokes(PlotView view, double pixel, Func<MoveStroke, bool> draw)
    {
        ArgumentNullException.ThrowIfNull(draw);
        return Count == 0 || Visit(_boxes.Length - 1, 0, new(view, Around(view), pixel, draw));
    }

    /// <summary>The strokes of one motion.</summary>
    public IReadOnlyList<MoveStroke> StrokesOf(int motion, PlotView view)
    {
        var strokes = new List<MoveStroke>();
        if (!Is(motion, Kind.Unknown))
        {
            Add(motion, new(view, Around(view), 1, Keep));
        }

        return strokes;

        bool Keep(MoveStroke stroke)
        {
            strokes.Add(stroke);
            return true;
        }
    }

    /// <summary>Start and end of a motion; null if only the machine knows them.</summary>
    public (Point2 From, Point2 To)? EndsOf(int motion) => Is(motion, Kind.Unknown) ? null : (StartOf(motion), _ends[motion]);

    /// <summary>The bounding box of a motion; empty if only the machine knows where it leads.</summary>
    public PlotBox BoxOf(int motion) => Is(motion, Kind.Unknown) ? PlotBox.Empty : BoxOf(motion, _motions[motion]);

    /// <summary>The motion nearest to a place, cuts before rapids; of several at the same distance, the first one. -1 if none is
    /// within reach.</summary>
    /// <param name="place">Where to look.</param>
    /// <param name="reach">Largest distance, mm.</param>
    public int Nearest(Point2 place, double reach)
    {
        var found = (Motion: -1, Distance: reach);
        if (Count > 0)
        {
            Search(_boxes.Length - 1, 0, place, double.IsFinite(reach) ? RapidPenalty * reach : 0, ref found);
        }

        return found.Motion;
    }

    /// <summary>The nearest place on a motion.</summary>
    public Point2 NearestOn(int motion, Point2 place)
    {
        if (Is(motion, Kind.Arc) && _motions[motion] is var m)
        {
            return m.Plane == _plane
                ? m.Arc.At(m.Arc.NearestFraction(place))
                : Chords(m, 64).Select(c => c.At(c.NearestFraction(place))).MinBy(p => p.DistanceTo(place));
        }

        var segment = new Segment2(StartOf(motion), _ends[motion]);
        return segment.Start == segment.End ? segment.Start : segment.At(segment.NearestFraction(place));
    }

    // Slightly larger than the visible box, so that line ends and joins at its border stay invisible.
    private static PlotBox Around(PlotView view) => view.Seen is var s
        ? new(
            s.Left - (DrawnSizes.Beyond / view.ScaleX),
            s.Low - (DrawnSizes.Beyond / view.ScaleY),
            s.Right + (DrawnSizes.Beyond / view.ScaleX),
            s.High + (DrawnSizes.Beyond / view.ScaleY))
        : default;

    private bool Visit(int level, int index, Seeing seeing)
    {
        var box = _boxes[level][index];
        if (box.IsEmpty || !box.Touches(seeing.Seen))
        {
            return true;
        }

        var (first, behind) = Motions(level, index);
        if ((box.Right - box.Left) * seeing.View.ScaleX < seeing.Pixel && (box.High - box.Low) * seeing.View.ScaleY < seeing.Pixel)
        {
            // All within one pixel.
            return seeing.Add(box.Middle, box.Middle, _motions.BlockOf(first), !_cuts[level][index]);
        }

        if (level > 0)
        {
            for (var child = index * Branch; child < Math.Min((index + 1) * Branch, _boxes[level - 1].Length); child++)
            {
                if (!Visit(level - 1, child, seeing))
                {
                    return false;
                }
            }

            return true;
        }

        return Add(first, behind, seeing);
    }

    // Straight moves that stay within half a pixel of the end of the last stroke are merged with the next one.
    private bool Add(int first, int behind, Seeing seeing)
    {
        var (from, isPending) = (default(Point2), false);
        for (var i = first; i < behind; i++)
        {
            if (Is(i, Kind.Unknown))
            {
                isPending = false;
                continue;
            }

            from = isPending ? from : StartOf(i);
            isPending = !Is(i, Kind.Arc | Kind.StartsElsewhere)
                && i + 1 < behind
                && _kinds[i + 1] == _kinds[i]
                && seeing.IsNear(from, _ends[i]);
            if (!isPending && !(Is(i, Kind.Arc) ? Add(i, seeing) : seeing.Add(from, _ends[i], _motions.BlockOf(i), Is(i, Kind.Rapid))))
            {
                return false;
            }
        }

        return true;
    }

    private bool Add(int motion, Seeing seeing)
    {
        var (block, isRapid) = (_motions.BlockOf(motion), Is(motion, Kind.Rapid));
        if (!Is(motion, Kind.Arc))
        {
            return seeing.Add(StartOf(motion), _ends[motion], block, isRapid);
        }

        var arc = _motions[motion];
        var radius = Math.Max(arc.Arc.Radius * Math.Max(seeing.View.ScaleX, seeing.View.ScaleY) / seeing.Pixel, ChordError);
        var chords = (int)Math.Clamp(
            Math.Ceiling(Math.Abs(arc.Arc.Sweep.Radians) / (2 * Elementary.Acos(1 - (ChordError / radius)))), 1, MostChords);
        foreach (var chord in Chords(arc, chords))
        {
            if (!seeing.Add(chord.Start, chord.End, block, isRapid))
            {
                return false;
            }
        }

        return true;
    }

    private void Search(int level, int index, Point2 place, double penalty, ref (int Motion, double Distance) found)
    {
        if (!(Distance(_boxes[level][index], place) <= found.Distance))
        {
            return;
        }

        if (level > 0)
        {
            // Nearest box first: the others can then often be skipped.
            var children = Enumerable.Range(
                index * Branch,
                Math.Min(Branch, _boxes[level - 1].Length - (index * Branch))).OrderBy(c => Distance(_boxes[level - 1][c], place));
            foreach (var child in children)
            {
                Search(level - 1, child, place, penalty, ref found);
            }

            return;
        }

        var (first, behind) = Motions(level, index);
        for (var i = first; i < behind; i++)
        {
            if (Is(i, Kind.Unknown))
            {
                continue;
            }

            var distance = NearestOn(i, place).DistanceTo(place) + (Is(i, Kind.Rapid) ? penalty : 0);
            if (distance < found.Distance || (distance == found.Distance && (found.Motion < 0 || i < found.Motion)))
            {
                found = (i, distance);
            }
        }
    }

    private static double Distance(PlotBox box, Point2 place) => box.IsEmpty
        ? double.PositiveInfinity
        : new Vector2(
            Math.Max(0, Math.Max(box.Left - place.X, place.X - box.Right)),
            Math.Max(0, Math.Max(box.Low - place.Y, place.Y - box.High))).Length;

    private (int First, int Behind) Motions(int level, int index)
    {
        var size = Leaf;
        for (var i = 0; i < level; i++)
        {
            size *= Branch;
        }

        return (index * size, (int)Math.Min((index + 1L) * size, Count));
    }

    private bool Is(int motion, Kind kind) => (_kinds[motion] & kind) != Kind.Straight;

    private Point2 StartOf(int motion) =>
        Is(motion, Kind.StartsElsewhere) ? StartOf(_motions[motion]) : motion == 0 ? _ends[0] : _ends[motion - 1];

    // If only the machine knows the start, the motion is drawn as a point at its end.
    private Point2 StartOf(NcMotion motion) =>
        (motion.UnknownStart & _axes) == AxisSet.None ? _plane.Project(motion.Start) : _plane.Project(motion.End);

    private Kind KindOf(NcMotion motion, Point2? before)
    {
        var kind = motion.Kind is MotionKind.Rapid or MotionKind.Reference ? Kind.Rapid : Kind.Straight;
        kind |= (motion.UnknownEnd & _axes) != AxisSet.None || !_plane.Project(motion.End).IsFinite ? Kind.Unknown : Kind.Straight;
        kind |= motion is { IsArc: true, IsKnownInPlane: true }
            && (motion.Flags & MotionFlags.BadArc) == MotionFlags.None
            && motion.PlaneStart != motion.Center
            ? Kind.Arc
            : Kind.Straight;
        return kind | (StartOf(motion) != (before ?? _plane.Project(motion.End)) ? Kind.StartsElsewhere : Kind.Straight);
    }

    private PlotBox BoxOf(int index, NcMotion motion)
    {
        var box = PlotBox.Empty.With(StartOf(index)).With(_ends[index]);
        if (!Is(index, Kind.Arc))
        {
            return box;
        }

        if (motion.Plane != _plane)
        {
            return Chords(motion, 64).Aggregate(box, (b, c) => b.With(c.End));
        }

        // An arc extends beyond its ends where it crosses an axis direction.
        var arc = motion.Arc;
        foreach (var way in (ReadOnlySpan<Vector2>)[new(1, 0), new(0, 1), new(-1, 0), new(0, -1)])
        {
            var tip = arc.Center + (arc.Radius * way);
            box = motion.Turns != 0 || arc.FractionOf(tip) is >= 0 and <= 1 ? box.With(tip) : box;
        }

        return box;
    }

    // Splits an arc into chords in the plane of the picture; a helix rises evenly.
    private IEnumerable<Segment2> Chords(NcMotion motion, int count)
    {
        var (from, rise, arc) = (
            motion.Plane.Height(motion.Start), motion.Plane.Height(motion.End) - motion.Plane.Height(motion.Start), motion.Arc);
        var last = StartOf(motion);
        for (var i = 1; i <= count; i++)
        {
            var share = (double)i / count;
            var next = i == count ? _plane.Project(motion.End) : _plane.Project(motion.Plane.Lift(arc.At(share), from + (share * rise)));
            yield return new(last, next);
            last = next;
        }
    }

    private sealed record Seeing(PlotView View, PlotBox Seen, double Pixel, Func<MoveStroke, bool> Draw)
    {
        public bool IsNear(Point2 a, Point2 b) =>
            Math.Abs(a.X - b.X) * View.ScaleX < Pixel / 2 && Math.Abs(a.Y - b.Y) * View.ScaleY < Pixel / 2;

        public bool Add(Point2 from, Point2 to, int block, bool isRapid)
        {
            if (Seen.PartOf(from, to) is not var (seenFrom, seenTo))
            {
                return true;
            }

            var (a, b) = (View.ToScreen(seenFrom), View.ToScreen(seenTo));
            return Draw(new((float)a.X, (float)a.Y, (float)b.X, (float)b.Y, block, isRapid));
        }
    }
}
