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

    // If both ends moved alike, the whole arc moved. Otherwise it passes through its old middle, moved by the mean of both ends'
    // displacements.
    public void CheckFollowing(in NcMotion was, in NcMotion now)
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

        var middle = was.PlaneAt(0.5) + ((start + end) / 2);
        if (!(now.Has(MotionFlags.ByRadius) && HasFittingRadius(was, now, middle)))
        {
            findings.Measure(was.Block, Math.Abs(now.Arc.Circle.SignedDistance(middle)), task.ArcTolerance + ProofTask.Mismatch(was));
        }
    }

    // Near half a turn, a radius that is right to an increment leaves the middle of the arc wherever the rounding puts it.
    private bool HasFittingRadius(in NcMotion was, in NcMotion now, Point2 middle)
    {
        if (Math.Abs(now.Arc.Radius - was.Arc.Radius) < 1e-6
            && Math.Abs(now.Arc.Sweep.Radians - was.Arc.Sweep.Radians) < 0.02 * Math.Abs(was.Arc.Sweep.Radians))
        {
            return true;
        }

        return CircleThrough(now.PlaneStart, middle, now.PlaneEnd) is { } circle
            && Math.Abs(now.Arc.Radius - circle.Radius) <= (1.5 * task.Increment) + 1e-6;
    }

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
