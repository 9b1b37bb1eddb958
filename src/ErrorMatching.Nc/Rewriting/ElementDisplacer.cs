using System.Collections;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Displaces elements: displaces each named line or arc, and moves the joints to the intersections.
/// <c>ElementDisplacer.Borders</c> handles the ends of a run of named motions.</summary>
internal sealed partial class ElementDisplacer
{
    /// <summary>Sine of the angle below which two elements count as tangent: 5.7 degrees.</summary>
    private const double TangentSine = 0.1;

    /// <summary>Sine of the angle below which the curvature of its elements does not affect a joint.</summary>
    private const double RoundSine = 0.001;

    /// <summary>Largest difference of the displacements of two elements that meet tangentially, mm: less than half a least
    /// increment.</summary>
    private const double TangentStep = 0.0004;

    /// <summary>Sine of the smallest angle at which two elements with different displacements count as meeting: half a degree.</summary>
    private const double SmallestCornerSine = 0.009;

    /// <summary>An intersection further from the joint than this multiple of the displacement is not nearby.</summary>
    private const double Nearby = 12;

    /// <summary>Places closer than this are the same, mm.</summary>
    private const double SamePlace = 1e-6;

    private readonly NcPath _path;
    private readonly PathChange _change;
    private readonly IReadOnlyList<ElementWish> _wishes;
    private readonly MotionRuns _asked = new();

    // The named elements and the fillets that move with them; the wishes of those fillets, and of full circles with both ends made exactly
    // alike; the new circles of fillets.
    private readonly MotionRuns _named = new();
    private readonly Dictionary<int, ElementWish> _otherWishes = [];
    private readonly Dictionary<int, Carrier> _rounded = [];
    private readonly HashSet<int> _shrunk = [];
    private readonly BitArray _smoothJoints;

    // The joints at the ends of runs, in the order in which they were set.
    private readonly List<int> _borders = [];

    private ElementDisplacer(NcPath path, IReadOnlyList<ElementWish> wishes)
    {
        _path = path;
        _change = new(path);
        _wishes = wishes;
        _smoothJoints = new(path.Motions.Length + 1);
    }

    /// <summary>Computes the new joints and centers for a wish.</summary>
    public static Outcome<PathChange> Run(NcPath path, DisplacementWish wish)
    {
        var displacer = new ElementDisplacer(path, wish.Elements);
        return displacer.Displace() is { } refusal ? refusal : displacer._change;
    }

    private Refusal? Displace()
    {
        var fillets = new List<ElementWish>();
        foreach (var element in WithNeighborFillets(_wishes))
        {
            if (Add(element) is { } refusal)
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
            if (Round(element) is { } refusal)
            {
                return refusal;
            }
        }

        var contours = new ContourSearch(_path.Motions, SamePlace, _named.Count);
        var closures = new (int Closing, int Opening)[_named.Count];
        for (var run = 0; run < _named.Count; run++)
        {
            var (first, last) = _named[run];
            var (closing, opening) = closures[run] = Closures(first, last, contours);
            if ((SmoothJoints(first, last) ?? CloseRings(first, last, closing, opening) ?? Corners(first, last)) is { } refusal)
            {
                return refusal;
            }
        }

        // What is between two runs is set once both runs are.
        for (var run = 0; run < _named.Count; run++)
        {
            var (first, last) = _named[run];
            var (closing, opening) = (Unnamed(closures[run].Closing), Unnamed(closures[run].Opening));
            if (Borders(first, last, closing, closing >= 0 ? -1 : opening) is { } refusal)
            {
                return refusal;
            }
        }

        return CarryPositioning() ?? FollowWithArcs() ?? CheckSense();
    }

    private Refusal? Add(ElementWish element)
    {
        var motion = _path.Motions[element.Motion];
        if (Obstacles.Of(_path, motion) is { } obstacle)
        {
            return obstacle;
        }

        if (!motion.IsKnownInPlane)
        {
            return Obstacles.UnknownPlace(_path, element.Motion);
        }

        if (Carrier.Displaced(motion, element) is not { } carrier)
        {
            return At(
                motion,
                NcRefusalCodes.ElementFlips,
                "displaced as asked, this element would vanish or turn round. The displacement is larger than the element can take.");
        }

        // Both ends of a full circle are exactly one place.
        var isClosed = motion.PlaneStart.DistanceTo(motion.PlaneEnd) < 1e-9 && (element.End - element.Start).Length < 1e-9;
        _named.Add(element.Motion);
        if (isClosed)
        {
            _otherWishes[element.Motion] = element with { End = element.Start };
        }

        if (carrier.Circle is { } circle)
        {
            _change.SetCenter(element.Motion, circle.Center);
        }

        return null;
    }

    private static bool IsTangent(Vector2 before, Vector2 behind) => Math.Abs(before.Cross(behind)) < TangentSine && before.Dot(behind) > 0;

    private Refusal? SmoothJoints(int first, int last)
    {
        // NaN if a joint is not smooth.
        var moves = new Vector2[last - first];
        if (Halves.Refusal(first + 1, last + 1, (from, behind) => SmoothMoves(first, from, behind, moves)) is { } unfit)
        {
            return unfit;
        }

        var plane = _path.Motions[first].Plane;
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (moves[joint - first - 1] is var move && !double.IsNaN(move.X))
            {
                _change.Move(joint, plane, move);
                _smoothJoints[joint] = true;
            }
        }

        return null;
    }

    private Refusal? Corners(int first, int last)
    {
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (!_change.IsSet(joint) && Corner(joint, first, last) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    // The displacements of the joints inside a run, if smooth and not yet set. Changes nothing, so two threads can run it.
    private Refusal? SmoothMoves(int first, int from, int behind, Vector2[] moves)
    {
        var begin = _path.Motions[first];
        for (var joint = from; joint < behind; joint++)
        {
            var motion = _path.Motions[joint];
            if (motion.Plane != begin.Plane)
            {
                return At(
                    motion,
                    NcRefusalCodes.PlaneChange,
                    "the plane changes inside the named blocks. Name the blocks of each plane as a feature of its own.");
            }

            if (motion.Frame != begin.Frame)
            {
                return At(motion, NcRefusalCodes.FrameChange, "the work offset or origin changes inside the named blocks.");
            }

            moves[joint - first - 1] = (_change.IsSet(joint) ? null : Smooth(joint - 1, joint)) ?? new(double.NaN, double.NaN);
        }

        return null;
    }

    /// <summary>The displacement of a joint on which both elements agree: a vertex of a polyline, or a tangential transition. Null at a
    /// corner.</summary>
    private Vector2? Smooth(int before, int behind)
    {
        var (moveA, moveB) = (WishOf(before).End, WishOf(behind).Start);
        if ((moveA - moveB).Length <= 1e-9)
        {
            return moveA;
        }

        var (tangentA, tangentB) = (_path.Motions[before].TangentAt(1), _path.Motions[behind].TangentAt(0));
        var (left, right) = (moveA.Dot(tangentA.Left), moveB.Dot(tangentB.Left));
        if (!IsTangent(tangentA, tangentB) || Math.Abs(left - right) > TangentStep)
        {
            return null;
        }

        var offset = (left + right) / 2;
        var move = (tangentA.Left + tangentB.Left) * (offset / (1 + tangentA.Dot(tangentB)));
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        return Math.Abs(tangentA.Cross(tangentB)) > RoundSine && (a.IsArc || b.IsArc)
            ? RoundMove(before, behind, tangentA.Left * offset, tangentB.Left * offset, move)
            : move;
    }

    // If one element is round, the tangents at the old joint meet away from the new joint. So the concentric circles through the displaced
    // joint are intersected, not the displaced circles: the ends of an arc with rounded words miss its circle.
    private Vector2 RoundMove(int before, int behind, Vector2 moveA, Vector2 moveB, Vector2 guess)
    {
        var place = _path.Motions[before].PlaneEnd;
        var (a, b) = (CarrierOf(before).Through(place + moveA), CarrierOf(behind).Through(place + moveB));
        return a.Meet(b, place + guess) is { } point && (point - place - guess).Length < TangentSine * guess.Length ? point - place : guess;
    }

    /// <summary>Moves a corner to the intersection of both displaced elements. If one of them is a short piece of a polyline that ends
    /// before the intersection, tries the next piece: the displacement cut off the pieces between, and they shrink to the corner.</summary>
    private Refusal? Corner(int joint, int first, int last)
    {
        var (before, behind) = (joint - 1, joint);
        var amount = Math.Max(WishOf(before).End.Length, WishOf(behind).Start.Length);
        while (Meet(before, behind, joint, amount) is { } point)
        {
            if (before > first && EndsBefore(before, point, atStart: true))
            {
                before--;
            }
            else if (behind < last && EndsBefore(behind, point, atStart: false))
            {
                behind++;
            }
            else
            {
                Shrink(before + 1, behind, point);
                return null;
            }
        }

        var (a, b) = (_path.Motions[joint - 1], _path.Motions[joint]);
        var (left, right) = (WishOf(joint - 1).End.Dot(a.TangentAt(1).Left), WishOf(joint).Start.Dot(b.TangentAt(0).Left));
        var (name, other) = (_path.Program.NameOf(_path.Program[b.Block]), _path.Program.NameOf(_path.Program[a.Block]));

        // An unnamed arc between two moving lines stays tangent to both: it is a corner, not a piece of one of them.
        var advice = IsTangent(a.TangentAt(1), b.TangentAt(0)) && a.IsArc != b.IsArc
            ? $"Where the arc {(a.IsArc ? other : name)} rounds a corner, do not name it: it then stays tangent to both of its neighbors. "
                + "Else displace both alike."
            : "Displace both alike, or displace less.";
        var amounts = FormattableString.Invariant($"({left:0.000} and {right:0.000} mm)");
        return At(
            b,
            NcRefusalCodes.NoIntersection,
            $"displaced as asked, it no longer meets {other} nearby: the two are displaced by different amounts {amounts}. {advice}");
    }

    private Point2? Meet(int before, int behind, int joint, double amount)
    {
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        var (tangentA, tangentB) = (a.TangentAt(1), b.TangentAt(0));
        if (Math.Abs(tangentA.Cross(tangentB)) < SmallestCornerSine)
        {
            return null;
        }

        var place = _path.Motions[joint].PlaneStart;
        var guess = a.PlaneEnd == b.PlaneStart
            ? place
                + CornerMove(tangentA.Left, WishOf(before).End.Dot(tangentA.Left), tangentB.Left, WishOf(behind).Start.Dot(tangentB.Left))
            : place;
        return CarrierOf(before).Meet(CarrierOf(behind), guess) is { } point && IsNear(point, place, amount) ? point : null;
    }

    // True if a displaced line of a polyline is wholly on the wrong side of a corner and a neighbor in the same polyline can replace it.
    private bool EndsBefore(int element, Point2 corner, bool atStart)
    {
        var motion = _path.Motions[element];
        var joint = atStart ? element : element + 1;
        if (motion.IsArc || !_smoothJoints[joint])
        {
            return false;
        }

        var far = (atStart ? motion.PlaneStart : motion.PlaneEnd) + _change.PlaneMoveOf(joint, motion.Plane);
        var beyond = (corner - far).Dot(motion.PlaneEnd - motion.PlaneStart);
        return atStart ? beyond <= 0 : beyond >= 0;
    }

    // Moves all joints from one to another to one point; the lines between them get length zero.
    private void Shrink(int firstJoint, int lastJoint, Point2 point)
    {
        var plane = _path.Motions[Math.Min(firstJoint, _path.Motions.Length - 1)].Plane;
        for (var joint = firstJoint; joint <= lastJoint; joint++)
        {
            _change.Move(
                joint, plane, point - (joint < _path.Motions.Length ? _path.Motions[joint].PlaneStart : _path.Motions[joint - 1].PlaneEnd));
        }

        for (var motion = firstJoint; motion < lastJoint; motion++)
        {
            _shrunk.Add(motion);
        }
    }

    // The displacement with the given components along two normals.
    private static Vector2 CornerMove(Vector2 normalA, double a, Vector2 normalB, double b) =>
        ((normalB.Left * -a) + (normalA.Left * b)) / normalA.Cross(normalB);

    private static bool IsNear(Point2 point, Point2 joint, double amount) => point.DistanceTo(joint) <= (Nearby * amount) + 1e-6;

    // Unnamed arcs whose ends left their circle: a lead-in arc, or an arc next to a run that it does not meet.
    private Refusal? FollowWithArcs()
    {
        var motions = _path.Motions;
        foreach (var i in _change.Affected())
        {
            if (motions.IsArc(i)
                && !_named.Contains(i)
                && !_change.HasCenter(i)
                && (_change.IsSet(i) || _change.IsSet(i + 1))
                && !SlidesOnCircle(i)
                && _change.FollowWithArc(i) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    private bool SlidesOnCircle(int motion)
    {
        var arc = _path.Motions[motion];
        var circle = arc.Arc.Circle;
        return IsAlong(arc.PlaneStart, _change.PlaneMoveOf(motion, arc.Plane))
            && IsAlong(arc.PlaneEnd, _change.PlaneMoveOf(motion + 1, arc.Plane));

        // An end whose radius differs from the start's within the control's tolerance still counts as on the circle.
        bool IsAlong(Point2 end, Vector2 move) =>
            Math.Abs(circle.SignedDistance(end + move)) <= Math.Abs(circle.SignedDistance(end)) + 1e-6;
    }

    // No element may reverse: that is a loop in the path, and a mark on the piece.
    private Refusal? CheckSense()
    {
        var affected = _change.Affected();
        return Halves.Refusal(0, affected.Count, (from, behind) => CheckSense(affected, from, behind));
    }

    private Refusal? CheckSense(List<int> affected, int from, int behind)
    {
        var motions = _path.Motions;
        for (var k = from; k < behind; k++)
        {
            var i = affected[k];
            if (motions[i] is not { IsCut: true, MovesInPlane: true } motion
                || !(_change.IsSet(i) || _change.IsSet(i + 1))
                || _shrunk.Contains(i))
            {
                continue;
            }

            if (!_change.KeepsSense(i))
            {
                return At(
                    motion,
                    NcRefusalCodes.ElementFlips,
                    "displaced as asked, this element would turn round: it is shorter than its neighbors' displacement needs. Leave it "
                        + "out of the program, or displace less.");
            }
        }

        return null;
    }

    private ElementWish WishOf(int motion) =>
        _otherWishes.Count > 0 && _otherWishes.TryGetValue(motion, out var other) ? other : _wishes[_asked.IndexOf(motion)];

    private Carrier CarrierOf(int motion) =>
        _rounded.TryGetValue(motion, out var fillet) ? fillet : Carrier.Displaced(_path.Motions[motion], WishOf(motion))!.Value;

    private Refusal At(in NcMotion motion, string code, string message) => BlockRefusal.At(_path.Program, motion.Block, code, message);
}
