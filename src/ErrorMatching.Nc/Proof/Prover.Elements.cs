using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Each motion against what was asked of it, measured on the piece: distances from the wished line or circle.</content>
public sealed partial class Prover
{
    /// <summary>Both coordinates of an end are rounded by up to half an increment.</summary>
    private double LineTolerance => (0.75 * increment) + 1e-6;

    /// <summary>Arcs add the rounding of their center.</summary>
    private double ArcTolerance => (1.6 * increment) + 1e-6;

    private void Measure(int block, double deviation, double tolerance)
    {
        maxDeviation = Math.Max(maxDeviation, deviation);
        if (!(deviation <= tolerance))
        {
            Fail(block, FormattableString.Invariant($"it lies {deviation:0.0000} mm from where it was wanted."));
        }
    }

    private void CheckElement(ElementWish element, in NcMotion was, in NcMotion now)
    {
        var (start, middle, end) = (was.PlaneStart + element.Start, was.PlaneAt(0.5) + element.Middle, was.PlaneEnd + element.End);
        if (!was.IsArc)
        {
            var wanted = Line2.Through(start, end);
            Measure(was.Block, Math.Abs(wanted.SignedDistance(now.PlaneStart)), LineTolerance);
            Measure(was.Block, Math.Abs(wanted.SignedDistance(now.PlaneEnd)), LineTolerance);
            if ((now.PlaneEnd - now.PlaneStart).Dot(was.PlaneEnd - was.PlaneStart) <= 0)
            {
                Fail(was.Block, "it turned round.");
            }
        }
        else if (element.IsFillet && FlanksOf(element.Motion) is var (first, second))
        {
            CheckFillet(was, now, first, second);
        }
        else
        {
            var circle = now.Arc.Circle;
            Measure(was.Block, Math.Abs(circle.SignedDistance(start)), ArcTolerance);
            Measure(was.Block, Math.Abs(circle.SignedDistance(middle)), ArcTolerance);
            Measure(was.Block, Math.Abs(circle.SignedDistance(end)), ArcTolerance);
        }

        CheckArc(was, now);
        CheckReach(was, element.Start, now.PlaneStart - was.PlaneStart);
        CheckReach(was, element.End, now.PlaneEnd - was.PlaneEnd);
    }

    // A vertex may run along its element to meet the neighbor, but not away.
    private void CheckReach(in NcMotion was, Vector2 wished, Vector2 moved)
    {
        if (moved.Length > (13 * wished.Length) + Math.Max(1.5 * was.PlaneLength, 0.1) + increment)
        {
            Fail(was.Block, FormattableString.Invariant($"an end went {moved.Length:0.000} mm although {wished.Length:0.000} mm were asked."));
        }
    }

    // The wished lines on both sides of a fillet, or null where the motion is none.
    private (Line2 First, Line2 Second)? FlanksOf(int motion) =>
        Fillet.Around(before, motion) is { } fillet && Flank(fillet.First - 1) is { } first && Flank(fillet.Last + 1) is { } second ? (first, second) : null;

    private Line2? Flank(int motion) => elements.TryGetValue(motion, out var element) && before.Motions[motion] is { IsArc: false } m
        ? Line2.Through(m.PlaneStart + element.Start, m.PlaneEnd + element.End)
        : null;

    private void CheckFillet(in NcMotion was, in NcMotion now, Line2 first, Line2 second)
    {
        var circle = now.Arc.Circle;
        Measure(was.Block, Math.Abs(Math.Abs(first.SignedDistance(circle.Center)) - circle.Radius), ArcTolerance);
        Measure(was.Block, Math.Abs(Math.Abs(second.SignedDistance(circle.Center)) - circle.Radius), ArcTolerance);
    }

    private void CheckArc(in NcMotion was, in NcMotion now)
    {
        if (!was.IsArc)
        {
            return;
        }

        var allowed = Math.Max(ArcCenter.Mismatch(was.PlaneStart, was.PlaneEnd, was.Center), 1.5 * increment);
        if (ArcCenter.Mismatch(now.PlaneStart, now.PlaneEnd, now.Center) > allowed + 1e-9)
        {
            Fail(was.Block, "the radii at its start and end differ by more than a control accepts.");
        }

        if (Math.Abs(now.Arc.Sweep.Radians - was.Arc.Sweep.Radians) > Math.PI / 2)
        {
            Fail(was.Block, "it turns by another angle than before.");
        }
    }

    private void CheckNeighbor(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var moved = endMoved ? now.PlaneEnd - was.PlaneEnd : now.PlaneStart - was.PlaneStart;
        if (!was.MovesInPlane || was.Kind is MotionKind.Rapid or MotionKind.Reference)
        {
            if (was.Kind == MotionKind.Line && !was.MovesInPlane && (now.PlaneEnd - now.PlaneStart).Length > 1e-9)
            {
                Fail(was.Block, "a move along the tool axis now moves in the plane.");
            }

            Note(was, NeighborRole.Positioning, moved);
            return;
        }

        CheckArc(was, now);
        if (startMoved && endMoved && FlanksOf(motion) is var (first, second))
        {
            CheckFillet(was, now, first, second);
            Note(was, NeighborRole.Fillet, moved);
        }
        else if (SlidAlong(was, now, startMoved, endMoved))
        {
            Note(was, NeighborRole.Slides, moved);
        }
        else if (FollowsWish(motion, was, now, startMoved, endMoved))
        {
            Note(was, NeighborRole.Follows, moved);
        }
        else
        {
            Fail(was.Block, "it neither kept to its own line or circle nor followed the motion beside it.");
        }
    }

    private void Note(in NcMotion was, NeighborRole role, Vector2 moved) =>
        neighbors.Add(new(before.Program.NameOf(before.Program[was.Block]), was.Block + 1, role, moved.Length));

    private bool SlidAlong(in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        if (was.IsArc)
        {
            var circle = was.Arc.Circle;
            return now.Center.DistanceTo(was.Center) <= 3 * increment
                && (!startMoved || Math.Abs(circle.SignedDistance(now.PlaneStart)) <= ArcTolerance) && (!endMoved || Math.Abs(circle.SignedDistance(now.PlaneEnd)) <= ArcTolerance);
        }

        var line = was.Segment.Line;
        return (!startMoved || Math.Abs(line.SignedDistance(now.PlaneStart)) <= LineTolerance) && (!endMoved || Math.Abs(line.SignedDistance(now.PlaneEnd)) <= LineTolerance);
    }

    private bool FollowsWish(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var start = !startMoved || Followed(motion, now.PlaneStart - was.PlaneStart);
        var end = !endMoved || Followed(motion + 1, now.PlaneEnd - was.PlaneEnd);
        return start && end;
    }

    // The joint went where the named motion beside it went, and that motion was measured itself; a lead-in may so take any vertex of its contour.
    private bool Followed(int joint, Vector2 moved) => JointMoves(joint).Any(m => (m - moved).Length <= 2 * increment);

    private IEnumerable<Vector2> JointMoves(int joint)
    {
        var place = joint < before.Motions.Length ? before.Motions[joint].Start : before.Motions[joint - 1].End;
        foreach (var motion in elements.Keys)
        {
            var (was, now) = (before.Motions[motion], after.Motions[motion]);
            if (Same(was.PlaneStart, was.Plane.Project(place)))
            {
                yield return now.PlaneStart - was.PlaneStart;
            }

            if (Same(was.PlaneEnd, was.Plane.Project(place)))
            {
                yield return now.PlaneEnd - was.PlaneEnd;
            }
        }
    }

    private void CheckEndPoint(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var named = wish.EndPoints.Contains(motion);
        if (named)
        {
            var off = now.End - was.End - wish.By;
            Measure(was.Block, Math.Max(Math.Abs(off.X), Math.Max(Math.Abs(off.Y), Math.Abs(off.Z))), (0.5 * increment) + 1e-6);
        }
        else if (endMoved)
        {
            var off = was.Plane.Project(now.End) - was.Plane.Project(was.End) - (was.Plane.Project(default(Point3) + wish.By) - Point2.Origin);
            Measure(was.Block, off.Length, increment);
        }

        CheckArc(was, now);
        if (!named && (startMoved || endMoved))
        {
            Note(was, was.MovesInPlane ? NeighborRole.Follows : NeighborRole.Positioning, (endMoved ? now.PlaneEnd - was.PlaneEnd : now.PlaneStart - was.PlaneStart));
        }
    }
}
