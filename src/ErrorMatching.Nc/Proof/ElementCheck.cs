using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks each named element against its wish: measures distances from the wished line or circle on the piece.</summary>
internal sealed class ElementCheck(ProofTask task, ProofFindings findings, ArcCheck arcs, FilletCheck fillets, JointCheck joints)
{
    public void Check(ElementWish element, in NcMotion was, in NcMotion now)
    {
        if (task.IsShrunk(element.Motion, was))
        {
            return;
        }

        if (!was.IsArc)
        {
            var line = Line2.Through(was.PlaneStart + element.Start, was.PlaneEnd + element.End);
            findings.Measure(was.Block, Math.Abs(line.SignedDistance(now.PlaneStart)), task.LineTolerance);
            findings.Measure(was.Block, Math.Abs(line.SignedDistance(now.PlaneEnd)), task.LineTolerance);
            if ((now.PlaneEnd - now.PlaneStart).Dot(was.PlaneEnd - was.PlaneStart) <= 0)
            {
                findings.Fail(was.Block, "it turned round.");
            }
        }
        else if (fillets.Is(element.Motion))
        {
            fillets.Check(element.Motion, was, now);
        }
        else if (WantedCircle(was, element) is { } wanted)
        {
            findings.Measure(was.Block, ProofTask.Furthest(now, wanted), task.ArcTolerance + ProofTask.Mismatch(was));
        }
        else
        {
            findings.Fail(was.Block, "no circle runs where it was wanted.");
        }

        arcs.CheckWords(was, now);
        CheckReach(was, now.PlaneStart - was.PlaneStart);
        CheckReach(was, now.PlaneEnd - was.PlaneEnd);
        joints.Check(was, element.Motion, element.Motion, element.Start);
        joints.Check(was, element.Motion, element.Motion + 1, element.End);
    }

    // An arc whose ends and middle have the same offset keeps its center. Any other passes through its displaced start, middle and end.
    // For a full circle, the displaced start and middle are the ends of a diameter.
    internal static Circle2? WantedCircle(in NcMotion was, ElementWish wish)
    {
        if (was.PlaneStart == was.Center || was.PlaneEnd == was.Center)
        {
            return null;
        }

        var arc = was.Arc;
        var (start, middle, end) = (was.PlaneStart + wish.Start, arc.Middle + wish.Middle, was.PlaneEnd + wish.End);
        var outward = (arc.Middle - arc.Center).Normalize().Dot(wish.Middle);
        var isOffset = IsOutward(was.PlaneStart, wish.Start) && IsOutward(was.PlaneEnd, wish.End);
        if (isOffset || Math.Abs(arc.Sweep.Degrees) > 359.9)
        {
            var radius = isOffset ? arc.Radius + outward : start.DistanceTo(middle) / 2;
            return radius > 0 ? new(isOffset ? arc.Center : start.Lerp(middle, 0.5), radius) : null;
        }

        return ArcCheck.CircleThrough(start, middle, end);

        bool IsOutward(Point2 at, Vector2 by) => Math.Abs((at - arc.Center).Normalize().Dot(by) - outward) < ProofTask.SamePlace;
    }

    // A vertex may move along its element to meet the neighbor, but only within reach.
    private void CheckReach(in NcMotion was, Vector2 moved)
    {
        if (moved.Length > task.Reach)
        {
            findings.Fail(
                was.Block,
                FormattableString.Invariant($"an end went {moved.Length:0.000} mm, further than any displacement asked for can explain."));
        }
    }
}
