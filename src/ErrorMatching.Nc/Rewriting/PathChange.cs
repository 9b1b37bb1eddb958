using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// New places for the joints of a path: joint i is where motion i begins and motion i - 1 ends. Arcs whose circle changes have a new center.
/// </summary>
internal sealed class PathChange
{
    private readonly Vector3[] moves;
    private readonly bool[] isSet;
    private readonly Dictionary<int, Point2> centers = [];

    public PathChange(NcPath path)
    {
        Path = path;
        moves = new Vector3[path.Motions.Length + 1];
        isSet = new bool[moves.Length];
    }

    public NcPath Path { get; }

    /// <summary>Arcs with a new exact center in their plane, by motion.</summary>
    public IReadOnlyDictionary<int, Point2> Centers => centers;

    public bool IsSet(int joint) => isSet[joint];

    public Vector3 MoveOf(int joint) => moves[joint];

    public void Move(int joint, Vector3 by)
    {
        moves[joint] = by;
        isSet[joint] = true;
    }

    public void Move(int joint, CoordinatePlane plane, Vector2 by) => Move(joint, plane.Lift(Point2.Origin + by, 0) - default(Point3));

    public void SetCenter(int motion, Point2 center) => centers[motion] = center;

    /// <summary>A joint's displacement in a plane.</summary>
    public Vector2 PlaneMoveOf(int joint, CoordinatePlane plane) => plane.Project(default(Point3) + moves[joint]) - Point2.Origin;

    /// <summary>Positioning that only goes to the place of a moved joint goes to its new place: plunges before it, retracts behind it.</summary>
    public void CarryPositioning(int joint)
    {
        var motions = Path.Motions;
        for (var before = joint - 1; before >= 0 && IsPlainPositioning(motions[before]) && !isSet[before]; before--)
        {
            Move(before, moves[joint]);
        }

        for (var behind = joint; behind < motions.Length && IsPlainPositioning(motions[behind]) && !isSet[behind + 1]; behind++)
        {
            Move(behind + 1, moves[joint]);
        }
    }

    private static bool IsPlainPositioning(in NcMotion motion) => motion is { MovesInPlane: false, Kind: MotionKind.Rapid or MotionKind.Line };
}
