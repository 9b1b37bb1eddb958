using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>New places for the joints of a path: joint i is the start of motion i and the end of motion i - 1. Arcs whose circle changes
/// have a new center.</summary>
internal sealed class PathChange
{
    private readonly SparseList<Vector3> _moves;
    private readonly SparseList<Point2> _centers;
    private readonly HashSet<int> _followers = [];
    private List<int>? _affected;

    public PathChange(NcPath path)
    {
        Path = path;
        _moves = new(path.Motions.Length + 1);
        _centers = new(path.Motions.Length);
    }

    public NcPath Path { get; }

    /// <summary>Arcs with a new exact center in their plane, in path order.</summary>
    public IEnumerable<int> ArcsWithCenter() => _centers.Positions();

    /// <summary>Motions with a moved end or a new center, in path order. The cost of a change grows with their number, not with the
    /// program. The list is cached; do not change it.</summary>
    public List<int> Affected() => _affected ??= FindAffected();

    private List<int> FindAffected()
    {
        var affected = new List<int>(_moves.Count + 1);
        foreach (var joint in _moves.Positions())
        {
            if (joint > 0 && (affected.Count == 0 || affected[^1] != joint - 1))
            {
                affected.Add(joint - 1);
            }

            if (joint < Path.Motions.Length)
            {
                affected.Add(joint);
            }
        }

        if (_centers.Positions().Any(c => !IsSet(c) && !IsSet(c + 1)))
        {
            affected = [.. affected.Union(_centers.Positions()).Order()];
        }

        return affected;
    }

    public bool IsSet(int joint) => _moves.Has(joint);

    public Vector3 MoveOf(int joint) => _moves[joint];

    /// <summary>True if an arc has a new center.</summary>
    public bool HasCenter(int motion) => _centers.Has(motion);

    /// <summary>The center of an arc in its plane: the new one, or the old one if it has none.</summary>
    public Point2 CenterOf(int motion, in NcMotion arc) => _centers.Has(motion) ? _centers[motion] : arc.Center;

    public void Move(int joint, Vector3 by) => (_moves[joint], _affected) = (by, null);

    public void Move(int joint, CoordinatePlane plane, Vector2 by) => Move(joint, plane.Lift(Point2.Origin + by, 0) - default(Point3));

    public void SetCenter(int motion, Point2 center) => (_centers[motion], _affected) = (center, null);

    /// <summary>True for an arc that follows its ends and has a new center.</summary>
    public bool Follows(int motion) => _followers.Contains(motion);

    /// <summary>A joint's displacement in a plane.</summary>
    public Vector2 PlaneMoveOf(int joint, CoordinatePlane plane) => plane.Project(default(Point3) + MoveOf(joint)) - Point2.Origin;

    /// <summary>False if an element would reverse: that is a loop in the path, and a mark on the piece.</summary>
    public bool KeepsSense(int motion)
    {
        var was = Path.Motions[motion];
        var start = was.PlaneStart + PlaneMoveOf(motion, was.Plane);
        var end = was.PlaneEnd + PlaneMoveOf(motion + 1, was.Plane);
        if (!was.IsArc)
        {
            return (end - start).Dot(was.PlaneEnd - was.PlaneStart) > 0;
        }

        var counterClockwise = was.Kind == MotionKind.ArcCounterClockwise;
        var before = Arc2.Between(was.PlaneStart, was.PlaneEnd, was.Center, counterClockwise).Sweep;
        var now = Arc2.Between(start, end, CenterOf(motion, was), counterClockwise).Sweep;
        return Math.Abs((now - before).Radians) < Math.PI / 2;
    }

    /// <summary>Lets an arc follow its ends. If both ends move alike, the whole arc moves. Otherwise it becomes the circle through its
    /// new ends and its old middle, moved by the mean of both ends' displacements.</summary>
    /// <returns>The reason why it cannot, or null.</returns>
    public Refusal? FollowWithArc(int motion)
    {
        var arc = Path.Motions[motion];
        var (start, end) = (PlaneMoveOf(motion, arc.Plane), PlaneMoveOf(motion + 1, arc.Plane));
        if (!arc.IsKnownInPlane && (start != default || end != default))
        {
            return Obstacles.Of(Path, motion) ?? Obstacles.UnknownPlace(Path, motion);
        }

        if (arc.Has(MotionFlags.BadArc) && (MoveOf(motion) != Vector3.Zero || MoveOf(motion + 1) != Vector3.Zero)
            && Obstacles.Of(Path, motion) is { } bad)
        {
            return bad;
        }

        var across = arc.Plane.Height(default(Point3) + (MoveOf(motion) - MoveOf(motion + 1)));
        if (arc.IsVertical && Math.Abs(across) > 1e-12)
        {
            return BlockRefusal.At(
                Path.Program,
                arc.Block,
                NcRefusalCodes.PlaneChange,
                "this arc stands upright and leads to a place that moves across its plane, while its other end stays: it would become a "
                    + "helix. Lead in from above the piece, with a rapid or a feed before the arc, or displace both sides alike.");
        }

        if ((start - end).Length < 1e-12)
        {
            SetCenter(motion, arc.Center + start);
            return null;
        }

        if (Obstacles.Of(Path, motion) is { } obstacle)
        {
            return obstacle;
        }

        if (arc.PlaneStart.DistanceTo(arc.PlaneEnd) > 1e-9
            && DisplacedCarrier.Of(arc, new(motion, start, (start + end) / 2, end))?.Circle is { } circle)
        {
            SetCenter(motion, circle.Center);
            _followers.Add(motion);
            if (KeepsSense(motion))
            {
                return null;
            }
        }

        return BlockRefusal.At(
            Path.Program,
            arc.Block,
            NcRefusalCodes.ElementFlips,
            "this arc cannot follow its end that moves. Name it as well, or leave out the block beside it.");
    }
}
