using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks a moved arc: a control accepts it, and its middle moved with its ends.</summary>
internal sealed class ArcCheck(ProofTask task, ProofFindings findings)
{
    /// <summary>Difference of the radii at both ends of an arc that every control accepts, mm.</summary>
    private const double AcceptedMismatch = 0.001;

    public void CheckWords(in NcMotion was, in NcMotion now)
    {
        if (!was.IsArc)
        {
            return;
        }

        var allowed = Math.Max(Math.Max(ProofTask.Mismatch(was), AcceptedMismatch), 1.5 * task.Increment);
        if (ProofTask.Mismatch(now) > allowed + 1e-9)
        {
            findings.Fail(was.Block, "the radii at its start and end differ by more than a control accepts.");
        }

        if (Math.Abs(now.Arc.Sweep.Radians - was.Arc.Sweep.Radians) > Math.PI / 2)
        {
            findings.Fail(was.Block, "it turns by another angle than before.");
        }
    }

    /// <summary>Checks a vertical arc in all three coordinates. If both of its ends moved alike, so did its center, and it is the same arc.
    /// Between two places that hold it, it may become another one in its plane, which passes through its old middle, moved by the mean of
    /// both ends' displacements.</summary>
    public void CheckVertical(in NcMotion was, in NcMotion now, bool isHeldOnBothSides)
    {
        var (start, end) = (now.Start - was.Start, now.End - was.End);
        if (Math.Abs(was.Plane.Height(now.Start) - was.Plane.Height(now.End)
            - (was.Plane.Height(was.Start) - was.Plane.Height(was.End))) > ProofTask.SamePlace)
        {
            findings.Fail(was.Block, "an upright arc left its plane: its ends moved differently across it.");
        }

        if (!isHeldOnBothSides && (start - end).Length > ProofTask.SamePlace)
        {
            findings.Fail(was.Block, "an upright arc did not move as a whole, although its other end is free.");
        }

        if ((start - end).Length <= ProofTask.SamePlace
            && Math.Abs(now.Center.DistanceTo(now.PlaneStart) - was.Center.DistanceTo(was.PlaneStart)) > 1e-6)
        {
            findings.Fail(was.Block, "an upright arc has another radius although it moved as a whole.");
        }

        CheckWords(was, now);
        CheckFollowing(was, now, null, null);
    }

    /// <summary>Checks that an arc follows its ends everywhere. If both ends moved alike, the whole arc moved. Otherwise it is on the
    /// circle through its displaced ends and its old middle, moved by the mean of both ends' displacements, and no place between its ends
    /// moved by more than they did.</summary>
    /// <param name="was">The motion in the original.</param>
    /// <param name="now">The motion in the result.</param>
    /// <param name="startWish">What was wished for its start, before rounding; null if nothing was.</param>
    /// <param name="endWish">The same for its end.</param>
    public void CheckFollowing(in NcMotion was, in NcMotion now, Vector2? startWish, Vector2? endWish)
    {
        if (!was.IsArc)
        {
            return;
        }

        var (start, end) = (now.PlaneStart - was.PlaneStart, now.PlaneEnd - was.PlaneEnd);
        if ((start - end).Length < 1e-9)
        {
            findings.Measure(was.Block, (now.Center - was.Center - start).Length, 1e-6);
            return;
        }

        (start, end) = (Unrounded(start, startWish), Unrounded(end, endWish));
        if (CircleThrough(was.PlaneStart + start, was.PlaneAt(0.5) + ((start + end) / 2), was.PlaneEnd + end) is not { } wanted)
        {
            findings.Fail(was.Block, "no circle runs where it was wanted.");
            return;
        }

        var allowed = task.ArcTolerance + ProofTask.Mismatch(was);
        findings.Measure(was.Block, ProofTask.Furthest(now, wanted), allowed);
        if (ProofTask.Moved(was, now) is var moved && moved > Math.Max(start.Length, end.Length) + allowed)
        {
            findings.Fail(
                was.Block, FormattableString.Invariant($"between its ends it moved by {moved:0.0000} mm, further than any of them."));
        }
    }

    // An end that is where the wish puts it was wished exactly there, not where rounding put it: at a short chord, that turns the circle.
    private Vector2 Unrounded(Vector2 moved, Vector2? wish) =>
        wish is { } exact && (moved - exact).Length <= task.Increment + 1e-6 ? exact : moved;

    // Null for points on one line, which have no circle.
    public static Circle2? CircleThrough(Point2 start, Point2 middle, Point2 end)
    {
        try
        {
            return Circle2.Through(start, middle, end);
        }
        catch (GeometryException)
        {
            return null;
        }
    }

    public bool EndsOnCircle(in NcMotion was, in NcMotion now)
    {
        var circle = was.Arc.Circle;
        var allowed = task.ArcTolerance + ProofTask.Mismatch(was);
        return Math.Abs(circle.SignedDistance(now.PlaneStart)) <= allowed && Math.Abs(circle.SignedDistance(now.PlaneEnd)) <= allowed;
    }
}
