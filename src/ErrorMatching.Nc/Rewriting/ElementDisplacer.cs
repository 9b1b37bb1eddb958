using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Displaces elements: displaces each named line or arc, and moves the joints to the intersections.</summary>
internal sealed class ElementDisplacer
{
    /// <summary>Centers and radii that differ by less are one circle, mm.</summary>
    private const double SameCircle = 0.01;

    private readonly NcPath _path;
    private readonly PathChange _change;
    private readonly DisplacedElements _elements;
    private readonly ShortPieces _pieces;
    private readonly FilletRounding _fillets;
    private readonly InnerJoints _inner;
    private readonly RunEnds _ends;
    private readonly RingClosing _rings;

    private ElementDisplacer(NcPath path, IReadOnlyList<ElementWish> wishes)
    {
        (_path, _change, _elements) = (path, new(path), new(path, wishes));
        var joints = new ElementJoints(_elements);
        _pieces = new(_change);
        _fillets = new(_elements, _change);
        _inner = new(_elements, _change, joints, _pieces);
        _ends = new(_elements, _change, _pieces);
        _rings = new(_elements, _change, joints, _ends);
    }

    /// <summary>Computes the new joints and centers for a wish.</summary>
    public static Outcome<PathChange> Run(NcPath path, DisplacementWish wish)
    {
        var displacer = new ElementDisplacer(path, wish.Elements);
        return displacer.Displace() is { } refusal ? refusal : displacer._change;
    }

    private Refusal? Displace() => AddElements() ?? MoveRuns() ?? _ends.CarryPositioning() ?? FollowWithArcs() ?? CheckSense();

    private Refusal? AddElements()
    {
        var fillets = new List<ElementWish>();
        foreach (var element in _elements.WithNeighborFillets())
        {
            if (_elements.Add(element, _change) is { } refusal)
            {
                return refusal;
            }

            if (element.IsFillet)
            {
                fillets.Add(element);
            }
        }

        foreach (var element in fillets)
        {
            if (_fillets.Round(element) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    private Refusal? MoveRuns()
    {
        var runs = _elements.Runs;
        var contours = new ContourSearch(_path.Motions, RunEnds.SamePlace, runs.Count);
        var closures = new (int Closing, int Opening)[runs.Count];
        for (var run = 0; run < runs.Count; run++)
        {
            var (first, last) = runs[run];
            var (closing, opening) = closures[run] = _rings.Closures(first, last, contours);
            if ((_rings.OpenPass(first, last, contours) ?? _inner.MoveSmooth(first, last)
                ?? _rings.Close(first, last, closing, opening) ?? _inner.MoveCorners(first, last))
                is { } refusal)
            {
                return refusal;
            }
        }

        // What is between two runs is set once both runs are. If a named motion closes a contour, both ends are already set.
        for (var run = 0; run < runs.Count; run++)
        {
            var (first, last) = runs[run];
            var (closing, opening) = (Unnamed(closures[run].Closing), Unnamed(closures[run].Opening));
            if (_ends.Move(first, last, closing, closing >= 0 ? -1 : opening) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    // A piece that shrank to one corner can be drawn out again by the next.
    private double Length(int i, in NcMotion motion) => (motion.PlaneEnd + _change.PlaneMoveOf(i + 1, motion.Plane))
        .DistanceTo(motion.PlaneStart + _change.PlaneMoveOf(i, motion.Plane));

    private int Unnamed(int motion) => motion >= 0 && _elements.Contains(motion) ? -1 : motion;

    // Unnamed arcs whose ends left their circle: a lead-in arc, or an arc next to a run that it does not meet.
    private Refusal? FollowWithArcs()
    {
        var motions = _path.Motions;
        foreach (var i in _change.Affected())
        {
            if (motions.IsArc(i)
                && !_elements.Contains(i)
                && !_change.HasCenter(i)
                && (_change.IsSet(i) || _change.IsSet(i + 1))
                && (motions.IsLeadArc(i) || !SlidesOnCircle(i))
                && (OnNamedCircle(i) ?? _change.FollowWithArc(i)) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    // A helix on the circle of a named arc cuts the same wall: moved aside as a whole, it would cut into it.
    private Refusal? OnNamedCircle(int helix)
    {
        var motion = _path.Motions[helix];
        for (var step = -1; step <= 1 && motion.IsHelixToAngle; step += 2)
        {
            var beside = helix + step;
            while (beside >= 0 && beside < _path.Motions.Length && _path.Motions[beside].IsHelixToAngle)
            {
                beside += step;
            }

            if (_elements.Contains(beside) && _path.Motions[beside] is { IsArc: true } arc
                && arc.Center.DistanceTo(motion.Center) < SameCircle && Math.Abs(arc.Arc.Radius - motion.Arc.Radius) < SameCircle)
            {
                return _elements.At(
                    motion,
                    NcRefusalCodes.ArcForm,
                    $"this helix cuts the same circle as {_elements.NameOf(beside)}, and its words cannot make it larger or smaller. "
                        + "Post it "
                        + "with coordinates, or lead in inside of the contour.");
            }
        }

        return null;
    }

    // Rounding leaves an end up to 0.7 increments off its circle. An end that is off by as much more is still meant to slide: a circle
    // that follows it would move its middle by half of what the end slides.
    private bool SlidesOnCircle(int motion)
    {
        var arc = _path.Motions[motion];
        var circle = arc.Arc.Circle;
        return IsAlong(arc.PlaneStart, _change.PlaneMoveOf(motion, arc.Plane))
            && IsAlong(arc.PlaneEnd, _change.PlaneMoveOf(motion + 1, arc.Plane));

        // An end whose radius differs from the start's within the control's tolerance still counts as on the circle.
        bool IsAlong(Point2 end, Vector2 move) =>
            move == default
                || Math.Abs(circle.SignedDistance(end + move)) <= Math.Abs(circle.SignedDistance(end)) + (1.4 * _elements.Increment);
    }

    // No element may reverse: that is a loop in the path, and a mark on the piece.
    private Refusal? CheckSense()
    {
        var affected = _change.Affected();
        return TwoThreads.Refusal(0, affected.Count, (from, end) => CheckSense(affected, from, end));
    }

    private Refusal? CheckSense(List<int> affected, int from, int end)
    {
        var motions = _path.Motions;
        for (var k = from; k < end; k++)
        {
            var i = affected[k];
            if (motions[i] is not { IsCut: true, MovesInPlane: true } motion
                || !(_change.IsSet(i) || _change.IsSet(i + 1))
                || (_pieces.AreShrunk(i) && Length(i, motion) < RunEnds.SamePlace))
            {
                continue;
            }

            if (motion.IsArc && motion.PlaneStart == motion.PlaneEnd && !_elements.Contains(i)
                && _change.PlaneMoveOf(i, motion.Plane) != _change.PlaneMoveOf(i + 1, motion.Plane))
            {
                return _elements.At(
                    motion,
                    NcRefusalCodes.ElementFlips,
                    "this full circle begins or ends where a displaced contour does, and would no longer close. Name it as well.");
            }

            if (!_change.KeepsSense(i))
            {
                return _elements.At(
                    motion,
                    NcRefusalCodes.ElementFlips,
                    "displaced as asked, this element would turn round: it is shorter than its neighbors' displacement needs. Leave it "
                        + "out of the program, or displace less.");
            }
        }

        return null;
    }
}
