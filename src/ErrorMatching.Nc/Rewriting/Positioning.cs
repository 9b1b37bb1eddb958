using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves positioning along the tool axis with a moved joint: plunges before a contour, retracts after it. A cut at the other end
/// shares the joint only if the tool kept cutting. If the tool was lifted or changed in between, the cut stays, and a rapid with its own
/// coordinates leads from one place to the other.</summary>
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
            while (end < motions.Length && !change.IsSet(end + 1) && IsAlongAxis(motions[end]))
            {
                end++;
            }

            if (end < motions.Length && change.IsSet(end + 1) && IsAlongAxis(motions[end]))
            {
                return Join(change, joint, end + 1, moved: joint);
            }

            if (end < motions.Length && IsCut(motions[end]) && !isNamed(end) && IsLifted(change.Path, joint, end))
            {
                return Join(change, joint, end, moved: joint);
            }

            Move(change, joint + 1, end, LevelMove(change, joint));
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
        while (first > 0 && !change.IsSet(first - 1) && IsAlongAxis(motions[first - 1]))
        {
            first--;
        }

        if (first > 0 && change.IsSet(first - 1) && IsAlongAxis(motions[first - 1]))
        {
            return Join(change, first - 1, joint, moved: joint);
        }

        var isHeld = first > 0 && !isNamed(first - 1) && (motions[first - 1].Has(MotionFlags.MachineMove)
            ? first < joint
            : IsCut(motions[first - 1]) && IsLifted(change.Path, first, joint));
        if (isHeld)
        {
            return Join(change, first, joint, moved: joint);
        }

        Move(change, first, joint - 1, LevelMove(change, joint));
        return null;
    }

    // Between two joints that are set, one rapid leads from one place to the other, unless both moved alike.
    private static Refusal? Join(PathChange change, int first, int last, int moved)
    {
        var (from, to) = (LevelMove(change, first), LevelMove(change, last));
        if (from == to && (first < last || from == Vector3.Zero))
        {
            Move(change, first + 1, last - 1, from);
            return null;
        }

        var motions = change.Path.Motions;
        for (var rapid = last - 1; rapid >= first; rapid--)
        {
            if (motions[rapid].Kind == MotionKind.Rapid && !LeavesCut(change.Path, rapid) && Obstacles.Of(change.Path, rapid) is null
                && StatesPlace(change.Path, rapid))
            {
                Move(change, first + 1, rapid, from);
                Move(change, rapid + 1, last - 1, to);
                return null;
            }
        }

        var (cut, other) = first == moved ? (Math.Min(last, motions.Length - 1), first - 1) : (first - 1, last);
        var name = change.Path.Program.NameOf(change.Path.Program[motions.BlockOf(other)]);
        return Refuse(
            change.Path, cut, NcRefusalCodes.NoPositioning,
            $"it shares a place with {name} and was cut separately: the tool was lifted or changed between them. "
            + "They no longer share it, and no rapid between them has coordinates of its own to lead from one to the other. "
            + "Insert one (G0 X Y) behind the retract, or displace both alike.");
    }

    private static void Move(PathChange change, int first, int last, Vector3 by)
    {
        for (var joint = first; joint <= last; joint++)
        {
            if (by != Vector3.Zero || change.IsSet(joint))
            {
                change.Move(joint, by);
            }
        }
    }

    // After an end that also moves along the tool axis, the tool goes to the programmed height.
    private static Vector3 LevelMove(PathChange change, int joint)
    {
        var motions = change.Path.Motions;
        var plane = motions[Math.Min(joint, motions.Length - 1)].Plane;
        return plane.Lift(plane.Project(default(Point3) + change.MoveOf(joint)), 0) - default(Point3);
    }

    // A return of the tool axis to a machine position leaves the other axes in place.
    private static bool IsAlongAxis(in NcMotion motion) =>
        motion is { MovesInPlane: false, Kind: MotionKind.Rapid or MotionKind.Line or MotionKind.Reference }
        && (!motion.Has(MotionFlags.MachineMove) || (motion.CarriedAxes & motion.Plane.Axes()) == motion.Plane.Axes());

    private static bool IsCut(in NcMotion motion) => motion is { IsCut: true, MovesInPlane: true } && !motion.Has(MotionFlags.MachineMove);

    // A stretch between cuts on which the tool did not keep cutting.
    private static bool IsLifted(NcPath path, int from, int behind)
    {
        var isLifted = path.ChangesTool(from, behind);
        for (var i = from; i < behind; i++)
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

    private static Refusal Refuse(NcPath path, int motion, string code, string message) =>
        BlockRefusal.At(path.Program, path.Motions.BlockOf(motion), code, message);
}
