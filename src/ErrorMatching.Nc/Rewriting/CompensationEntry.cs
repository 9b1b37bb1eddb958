using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Checks entries and exits of cutter compensation next to a displaced contour. A control moves the tool to the compensated path
/// on a straight move, and treats an inside corner there differently from an outside one. A straight transition must stay straight, and a
/// turn must keep its side. Otherwise the tool gouges the piece or the control stops with an alarm.</summary>
internal static class CompensationEntry
{
    /// <summary>Smallest allowed length of an entry or exit, as a fraction of its old length.</summary>
    private const double ShortestFraction = 0.5;

    /// <summary>The reason why a change would spoil an entry or exit; null if it does not.</summary>
    public static Refusal? Of(PathChange change)
    {
        var motions = change.Path.Motions;
        foreach (var i in change.Affected())
        {
            if (!motions.SwitchesCompensation(i))
            {
                continue;
            }

            var motion = motions[i];
            if (change.PlaneMoveOf(i, motion.Plane) == change.PlaneMoveOf(i + 1, motion.Plane) || change.Path.IsLead(motion))
            {
                continue;
            }

            if (motion.IsArc)
            {
                return Refuse(
                    change, motion, "it is an arc; cutter compensation begins and ends on a straight move only. Post a straight entry.");
            }

            var (was, now) = (motion.PlaneEnd - motion.PlaneStart, After(change, i));
            if (now.Length < ShortestFraction * was.Length || now.Dot(was) <= 0)
            {
                return Refuse(
                    change,
                    motion,
                    "it would get shorter than half of what it was, or turn round; the control needs its length to take up the tool "
                        + "radius. Displace less, or post a longer entry.");
            }

            var neighbor = motion.Has(MotionFlags.CompensationLeft) || motion.Has(MotionFlags.CompensationRight) ? i + 1 : i - 1;
            if (Turn(change, i, neighbor, displaced: false) is { } before
                && Turn(change, i, neighbor, displaced: true) is { } after
                && before * after < 0)
            {
                return Refuse(
                    change,
                    motion,
                    "its corner with the contour would change from inside to outside or back. Post the entry at a larger angle to the "
                        + "contour.");
            }
        }

        return null;
    }

    /// <summary>The reason why a change would let cutter compensation begin or end with another motion, or null: one that stood still in
    /// the plane after the switch, and would move now.</summary>
    public static Refusal? Earlier(PathChange change)
    {
        var motions = change.Path.Motions;
        foreach (var i in change.Affected())
        {
            // The first motion begins where the tool is.
            var start = i == 0 ? default : change.PlaneMoveOf(i, motions[i].Plane);
            if (motions[i].IsArc || motions[i].PlaneStart != motions[i].PlaneEnd
                || start == change.PlaneMoveOf(i + 1, motions[i].Plane))
            {
                continue;
            }

            var next = i + 1;
            while (next < motions.Length && !motions[next].IsArc && motions[next].PlaneStart == motions[next].PlaneEnd)
            {
                next++;
            }

            if (next < motions.Length && motions.SwitchesCompensation(next))
            {
                return Refuse(
                    change, motions[i],
                    "it would be the first motion after the switch, and so the one with which it takes effect. Post the switch in the "
                        + "block that moves.");
            }
        }

        return null;
    }

    private static Vector2 After(PathChange change, int i)
    {
        var motion = change.Path.Motions[i];
        return motion.PlaneEnd + change.PlaneMoveOf(i + 1, motion.Plane) - (motion.PlaneStart + change.PlaneMoveOf(i, motion.Plane));
    }

    // Sine of the turn between an entry and the contour after it, or the contour and the exit after it; null if it is below 0.001 or there
    // is no contour.
    private static double? Turn(PathChange change, int entry, int neighbor, bool displaced)
    {
        var motions = change.Path.Motions;
        if (neighbor < 0 || neighbor >= motions.Length || motions[neighbor] is not { IsCut: true, MovesInPlane: true } contour)
        {
            return null;
        }

        var own = displaced ? After(change, entry) : motions[entry].PlaneEnd - motions[entry].PlaneStart;
        var beside = contour.IsArc
            ? contour.TangentAt(neighbor > entry ? 0 : 1)
            : displaced
            ? After(change, neighbor)
            : contour.PlaneEnd - contour.PlaneStart;
        if (own.Length < 1e-9 || beside.Length < 1e-9)
        {
            return null;
        }

        var sine = own.Cross(beside) / own.Length / beside.Length;
        return Math.Abs(sine) < 1e-3 ? null : sine;
    }

    private static Refusal Refuse(PathChange change, in NcMotion motion, string why) =>
        BlockRefusal.At(
            change.Path.Program,
            motion.Block,
            NcRefusalCodes.CompensationEntry,
            $"cutter compensation is switched here, and displaced as asked {why}");
}
