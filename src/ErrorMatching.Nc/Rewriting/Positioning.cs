using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves positioning along the tool axis with a moved joint: plunges before a contour, retracts after it, and the vertical arcs of
/// its leads, which keep their form. A cut at the other end shares the joint only if the tool kept cutting. If the tool was lifted or
/// changed in between, the cut stays, and a rapid with its own coordinates leads from one place to the other.</summary>
internal static class Positioning
{
    /// <summary>Moves what follows a moved joint, up to the first motion in the plane.</summary>
    /// <param name="change">The change; the joints of named motions are set.</param>
    /// <param name="joint">The joint.</param>
    /// <param name="isNamed">Whether a motion is named and so may begin or end elsewhere.</param>
    /// <returns>The reason why it cannot move, or null.</returns>
    public static Refusal? CarryAhead(PathChange change, int joint, Func<int, bool> isNamed)
    {
        var motions = change.Path.Motions;
        while (true)
        {
            var end = joint;
            while (end < motions.Length && !change.IsSet(end + 1) && GoesAlong(motions[end]))
            {
                end++;
            }

            if (end < motions.Length && change.IsSet(end + 1) && GoesAlong(motions[end]))
            {
                return Join(change, joint, end + 1, moved: joint);
            }

            if (end < motions.Length && IsCut(motions[end]) && !isNamed(end) && IsLifted(change.Path, joint, end)
                && !IsAbove(change.Path, joint, end))
            {
                return Join(change, joint, end, moved: joint);
            }

            Move(change, joint, end);
            if (end == motions.Length || !motions[end].Has(MotionFlags.MachineMove) || change.IsSet(end + 1)
                || change.MoveOf(end) == Vector3.Zero)
            {
                return null;
            }

            if (motions[end].Has(MotionFlags.Transformed))
            {
                return Refuse(
                    change.Path, end, NcRefusalCodes.ActiveTransform,
                    "it goes from a moved place to one of the machine while coordinates are turned. Leave the contour before it.");
            }

            var carried = Only(motions[end].CarriedAxes & ~motions[end].UnknownEnd, change.MoveOf(end));
            if (carried == Vector3.Zero)
            {
                return null;
            }

            change.Move(end + 1, carried);
            joint = end + 1;
        }
    }

    /// <summary>Moves what leads to a moved joint, back to the last motion in the plane.</summary>
    /// <returns>The reason why it cannot move, or null.</returns>
    public static Refusal? CarryBack(PathChange change, int joint, Func<int, bool> isNamed)
    {
        var motions = change.Path.Motions;
        var first = joint;
        while (first > 0 && !change.IsSet(first - 1) && GoesAlong(motions[first - 1]))
        {
            first--;
        }

        if (first > 0 && change.IsSet(first - 1) && GoesAlong(motions[first - 1]))
        {
            return Join(change, first - 1, joint, moved: joint);
        }

        var isHeld = first > 0 && !isNamed(first - 1) && (motions[first - 1].Has(MotionFlags.MachineMove)
            ? first < joint
            : IsCut(motions[first - 1]) && IsLifted(change.Path, first, joint) && !IsAbove(change.Path, joint, first));
        if (isHeld)
        {
            return Join(change, first, joint, moved: joint);
        }

        Move(change, joint, first);
        return null;
    }

    // Between two joints that are set, one rapid leads from one place to the other, unless both moved alike. Without a rapid, a vertical
    // arc can become another one in its plane.
    private static Refusal? Join(PathChange change, int first, int last, int moved)
    {
        var motions = change.Path.Motions;
        var level = last - 1;
        while (level >= first && motions.IsLeadArc(level))
        {
            level--;
        }

        var isArcs = level < first && first < last;
        var (from, to) = isArcs ? (change.MoveOf(first), change.MoveOf(last)) : (LevelMove(change, first), LevelMove(change, last));
        if (from == to && (first < last || from == Vector3.Zero))
        {
            Split(change, first, Math.Max(first, level), last);
            return null;
        }

        for (var rapid = last - 1; rapid >= first; rapid--)
        {
            if (motions[rapid].Kind == MotionKind.Rapid && !LeavesCut(change.Path, rapid) && Obstacles.Of(change.Path, rapid) is null
                && StatesPlace(change.Path, rapid))
            {
                Split(change, first, rapid, last);
                return null;
            }
        }

        for (var i = 0; i < last - first; i++)
        {
            var arc = first == moved ? last - 1 - i : first + i;
            if (motions.IsVertical(arc) && motions[arc].Plane.Height(default(Point3) + (from - to)) == 0)
            {
                Split(change, first, arc, last);
                return null;
            }
        }

        var (cut, other) = first == moved ? (Math.Min(last, motions.Length - 1), first - 1) : (first - 1, last);
        var name = NameOf(change.Path, other);
        if (Enumerable.Range(first, last - first).FirstOrDefault(motions.IsVertical, -1) is >= 0 and var helix)
        {
            return Refuse(
                change.Path, helix, NcRefusalCodes.NoPositioning,
                $"it stands upright between {name}, which moves across its plane, and {NameOf(change.Path, cut)}, which stays: it would "
                + "become a helix. Reach it from above the piece by a rapid with coordinates of its own (G0 X Y), or displace both alike.");
        }

        return Refuse(
            change.Path, cut, NcRefusalCodes.NoPositioning,
            $"it shares a place with {name} and was cut separately: the tool was lifted or changed between them. "
            + "They no longer share it, and no rapid between them has coordinates of its own to lead from one to the other. "
            + "Insert one (G0 X Y) behind the retract, or displace both alike.");
    }

    private static void Split(PathChange change, int first, int motion, int last)
    {
        Move(change, first, motion);
        Move(change, last, motion + 1);
    }

    // Moves the joints behind or before one up to another as that moved. On the other side of a move along the tool axis, the tool is at
    // its programmed height.
    private static void Move(PathChange change, int from, int to)
    {
        var motions = change.Path.Motions;
        var (by, step) = (change.MoveOf(from), Math.Sign(to - from));
        for (var joint = from + step; joint != to + step && step != 0; joint += step)
        {
            var motion = Math.Min(joint, joint - step);
            by = motions.IsLeadArc(motion) ? by : Level(by, motions[motion].Plane);
            if (by != Vector3.Zero || change.IsSet(joint))
            {
                change.Move(joint, by);
            }
        }
    }

    private static Vector3 Level(Vector3 by, CoordinatePlane plane) =>
        plane.Lift(plane.Project(default(Point3) + by), 0) - default(Point3);

    // After an end that also moves along the tool axis, the tool goes to the programmed height.
    private static Vector3 LevelMove(PathChange change, int joint)
    {
        var motions = change.Path.Motions;
        var near = motions[Math.Min(joint, motions.Length - 1)];
        return Level(change.MoveOf(joint), near.IsVertical ? CoordinatePlane.XY : near.Plane);
    }

    // A return of the tool axis to a machine position leaves the other axes in place.
    private static bool IsAlongAxis(in NcMotion motion) =>
        motion is { MovesInPlane: false, Kind: MotionKind.Rapid or MotionKind.Line or MotionKind.Reference }
        && (!motion.Has(MotionFlags.MachineMove) || (motion.CarriedAxes & motion.Plane.Axes()) == motion.Plane.Axes());

    // What keeps its way when one of its ends moves.
    private static bool GoesAlong(in NcMotion motion) => motion.IsLeadArc || IsAlongAxis(motion);

    // A vertical arc or a helix leads down from the other end, where the tool is above the contour: the way there may end elsewhere.
    private static bool IsAbove(NcPath path, int joint, int other)
    {
        var (first, end) = (Math.Min(joint, other), Math.Max(joint, other));
        var hasArc = false;
        for (var i = first; i < end; i++)
        {
            hasArc |= path.Motions.IsLeadArc(i);
        }

        return hasArc && path.Motions.PlaceOf(other).Z > path.Motions.PlaceOf(joint).Z;
    }

    private static bool IsCut(in NcMotion motion) => motion is { IsCut: true, MovesInPlane: true } && !motion.Has(MotionFlags.MachineMove);

    // A stretch between cuts on which the tool did not keep cutting.
    private static bool IsLifted(NcPath path, int from, int end)
    {
        var isLifted = path.ChangesTool(from, end);
        for (var i = from; i < end; i++)
        {
            isLifted |= path.Motions[i].Kind != MotionKind.Line;
        }

        return isLifted;
    }

    private static bool LeavesCut(NcPath path, int motion) =>
        motion > 0 && path.Motions[motion - 1].IsCut && !path.ChangesTool(motion, motion);

    private static bool StatesPlace(NcPath path, int motion)
    {
        var axes = path.Motions[motion].Plane.Axes();
        foreach (ref readonly var token in path.Program.Tokens(path.Program[path.Motions.BlockOf(motion)]))
        {
            if (token is { Kind: NcTokenKind.Word, Letter: >= (byte)'X' and <= (byte)'Z' }
                && (axes & (AxisSet)(1 << (token.Letter - 'X'))) != AxisSet.None)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>A vector along some axes only.</summary>
    public static Vector3 Only(AxisSet axes, Vector3 by) => new(
        (axes & AxisSet.X) == AxisSet.None ? 0 : by.X,
        (axes & AxisSet.Y) == AxisSet.None ? 0 : by.Y,
        (axes & AxisSet.Z) == AxisSet.None ? 0 : by.Z);

    private static string NameOf(NcPath path, int motion) => path.Program.NameOf(path.Program[path.Motions.BlockOf(motion)]);

    private static Refusal Refuse(NcPath path, int motion, string code, string message) =>
        BlockRefusal.At(path.Program, path.Motions.BlockOf(motion), code, message);
}
