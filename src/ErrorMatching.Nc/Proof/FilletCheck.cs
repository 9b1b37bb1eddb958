using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks rounded corners: one or more arcs of one circle that touch a named line on either side and must stay tangent. The foot
/// of the center on a line shows whether the circle touches it. The corner of both lines and the tangent length show where the circle
/// must be. The rewriter uses directions and parallel lines instead, so one error does not blind both.</summary>
internal sealed class FilletCheck(ProofTask task, ProofFindings findings)
{
    /// <summary>Allowed distance of the center's foot on a line from the joint, in radii: the sine of 2.9 degrees.</summary>
    private const double FootShare = 0.05;

    /// <summary>Allowed difference of the centers and radii of arcs of one fillet, mm.</summary>
    private const double SameCircle = 0.01;

    /// <summary>A joint between two arcs of a fillet is rounded, and so is the center that its direction is measured from.</summary>
    private double JointTolerance => (5 * task.Increment) + 1e-6;

    /// <summary>True for an arc that joins two named lines tangentially and is either not named or named as a fillet.</summary>
    public bool Is(int motion) => (task.Elements.IndexOf(motion) is var element && (element < 0 || task.Wish.Elements[element].IsFillet))
        && Around(motion) is var (first, last) && task.Flank(first - 1) is not null && task.Flank(last + 1) is not null;

    /// <summary>True if the motions are all arcs of one such fillet.</summary>
    public bool IsWhole(int first, int last) => Is(first) && Around(first) == (first, last);

    /// <summary>Measures the arc where it cuts and checks that it ends where it touches. A joint between two of its arcs keeps its
    /// direction from the center.</summary>
    public void Check(int motion, in NcMotion was, in NcMotion now)
    {
        var (first, last) = Around(motion)!.Value;
        if (Wanted(first, last) is not var (circle, touchesFirst, touchesLast))
        {
            findings.Fail(was.Block, "no arc of the radius that the fillet must have touches the lines beside it.");
            return;
        }

        var allowed = task.ArcTolerance + ProofTask.Mismatch(was) + Math.Abs(was.Arc.Radius - task.Before.Motions[first].Arc.Radius);
        findings.Measure(was.Block, Math.Abs(circle.SignedDistance(now.PlaneStart)), allowed);
        findings.Measure(was.Block, Math.Abs(circle.SignedDistance(now.Arc.Middle)), allowed);
        findings.Measure(was.Block, Math.Abs(circle.SignedDistance(now.PlaneEnd)), allowed);
        var start = motion == first ? touchesFirst : circle.Center + ((was.PlaneStart - was.Center).Normalize() * circle.Radius);
        var end = motion == last ? touchesLast : circle.Center + ((was.PlaneEnd - was.Center).Normalize() * circle.Radius);
        if (now.PlaneStart.DistanceTo(start) > (motion == first ? task.LineTolerance : JointTolerance)
            || now.PlaneEnd.DistanceTo(end) > (motion == last ? task.LineTolerance : JointTolerance))
        {
            findings.Fail(was.Block, "the fillet does not end where it touches the lines beside it.");
        }
    }

    /// <summary>The circle that touches both wished lines, and the points where it touches. Its radius changed by the mean offset of the
    /// two lines. Lines that turn by an angle a are touched at r tan(a / 2) before and after their corner.</summary>
    private (Circle2 Circle, Point2 First, Point2 Last)? Wanted(int first, int last)
    {
        var (before, behind) = (task.Flank(first - 1)!.Value, task.Flank(last + 1)!.Value);
        var was = task.Before.Motions[first];
        var turn = was.Kind == MotionKind.ArcCounterClockwise ? 1 : -1;
        var left = WishOf(first - 1).End.Dot(before.Normal) + WishOf(last + 1).Start.Dot(behind.Normal);
        var radius = was.PlaneStart.DistanceTo(was.Center) - (turn * left / 2);
        if (radius <= 0 || Intersect.Lines(before, behind) is not { Count: 1, First: var corner })
        {
            return null;
        }

        var leftward = turn * radius;
        var tangent = leftward * before.Direction.Cross(behind.Direction) / (1 + before.Direction.Dot(behind.Direction));
        var (from, to) = (corner - (before.Direction * tangent), corner + (behind.Direction * tangent));
        return (new(from + (before.Normal * leftward), radius), from, to);
    }

    private ElementWish WishOf(int motion) => task.Wish.Elements[task.Elements.IndexOf(motion)];

    // The first and last arc of a motion's fillet; null if it is not part of one.
    private (int First, int Last)? Around(int motion)
    {
        var motions = task.Before.Motions;
        var arc = motions[motion];
        if (!arc.IsArc)
        {
            return null;
        }

        var (before, behind) = (motion - 1, motion + 1);
        while (before >= 0 && IsPieceOf(motions[before], arc))
        {
            before--;
        }

        while (behind < motions.Length && IsPieceOf(motions[behind], arc))
        {
            behind++;
        }

        return before >= 0 && behind < motions.Length
            && Touches(motions[before], motions[before + 1], motions[before + 1].PlaneStart)
            && Touches(motions[behind], motions[behind - 1], motions[behind - 1].PlaneEnd) ? (before + 1, behind - 1) : null;
    }

    private static bool IsPieceOf(in NcMotion other, in NcMotion arc) => other.Kind == arc.Kind && other.Plane == arc.Plane
        && other.Center.DistanceTo(arc.Center) < SameCircle
        && Math.Abs(other.PlaneStart.DistanceTo(other.Center) - arc.PlaneStart.DistanceTo(arc.Center)) < SameCircle;

    // The foot of the center is the joint, and the center is on the side to which the arc turns.
    private static bool Touches(in NcMotion line, in NcMotion arc, Point2 joint)
    {
        if (line.Kind != MotionKind.Line || line.Plane != arc.Plane || line.PlaneStart == line.PlaneEnd)
        {
            return false;
        }

        var (direction, toCenter) = ((line.PlaneEnd - line.PlaneStart).Normalize(), arc.Center - joint);
        var isLeft = direction.Cross(toCenter) > 0;
        return Math.Abs(direction.Dot(toCenter)) < FootShare * toCenter.Length && isLeft == (arc.Kind == MotionKind.ArcCounterClockwise);
    }
}
