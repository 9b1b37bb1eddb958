using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Each motion against what was asked of it, measured on the piece: distances from the wished line or circle.</content>
public sealed partial class Prover
{
    /// <summary>Both coordinates of an end are rounded by up to half an increment.</summary>
    private double LineTolerance => (0.75 * _increment) + 1e-6;

    /// <summary>Arcs add the rounding of their center.</summary>
    private double ArcTolerance => (1.6 * _increment) + 1e-6;

    /// <summary>A fillet's ends are rounded, and so is the center whose feet they are.</summary>
    private double FootTolerance => (5 * _increment) + 1e-6;

    /// <summary>How far the radii at both ends of an arc may differ on every control, mm.</summary>
    private const double AcceptedMismatch = 0.001;

    private static double Mismatch(in NcMotion motion) => ArcCenter.Mismatch(motion.PlaneStart, motion.PlaneEnd, motion.Center);

    private void Measure(int block, double deviation, double tolerance)
    {
        _maxDeviation = Math.Max(_maxDeviation, deviation);
        if (!(deviation <= tolerance))
        {
            Fail(block, FormattableString.Invariant($"it lies {deviation:0.0000} mm from where it was wanted."));
        }
    }

    private void CheckElement(ElementWish element, in NcMotion was, in NcMotion now)
    {
        if (IsShrunk(element.Motion, was))
        {
            return;
        }

        if (!was.IsArc)
        {
            var line = Line2.Through(was.PlaneStart + element.Start, was.PlaneEnd + element.End);
            Measure(was.Block, Math.Abs(line.SignedDistance(now.PlaneStart)), LineTolerance);
            Measure(was.Block, Math.Abs(line.SignedDistance(now.PlaneEnd)), LineTolerance);
            if ((now.PlaneEnd - now.PlaneStart).Dot(was.PlaneEnd - was.PlaneStart) <= 0)
            {
                Fail(was.Block, "it turned round.");
            }
        }
        else if (IsFillet(element.Motion))
        {
            CheckFillet(element.Motion, was, now);
        }
        else if (WantedCircle(was, element) is { } wanted)
        {
            // Where it cuts, and at quarters of its first turn: the center of a full circle that went aside shows only there.
            for (var quarter = 0; quarter <= 4; quarter++)
            {
                var place = now.PlaneAt(quarter / (4.0 * (now.Turns + 1)));
                Measure(was.Block, Math.Abs(wanted.SignedDistance(place)), ArcTolerance + Mismatch(was));
            }
        }
        else
        {
            Fail(was.Block, "no circle runs where it was wanted.");
        }

        CheckArc(was, now);
        CheckReach(was, now.PlaneStart - was.PlaneStart);
        CheckReach(was, now.PlaneEnd - was.PlaneEnd);
        CheckJoint(was, element.Motion, element.Motion, element.Start);
        CheckJoint(was, element.Motion, element.Motion + 1, element.End);
    }

    // An arc that is offset alike keeps its center; another runs through its displaced start, middle and end. A full circle has its
    // displaced start and middle as a diameter.
    private static Circle2? WantedCircle(in NcMotion was, ElementWish wish)
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

        return CircleThrough(start, middle, end);

        bool IsOutward(Point2 at, Vector2 by) => Math.Abs((at - arc.Center).Normalize().Dot(by) - outward) < SamePlace;
    }

    // A vertex may run along its element to meet the neighbor, but not away.
    private void CheckReach(in NcMotion was, Vector2 moved)
    {
        if (moved.Length > _reach)
        {
            Fail(was.Block, FormattableString.Invariant($"an end went {moved.Length:0.000} mm, further than any displacement asked for can explain."));
        }
    }

    private Line2? Flank(int motion) => _elements.IndexOf(motion) is >= 0 and var index && _before.Motions[motion] is { IsArc: false } m
        ? Line2.Through(m.PlaneStart + _wish.Elements[index].Start, m.PlaneEnd + _wish.Elements[index].End)
        : null;

    // A fillet is the arc that touches both lines beside it; its radius changed by the mean of what these were offset by. It is measured where it cuts, and ends where it touches; a joint between two of its arcs
    // keeps its direction from the center.
    private void CheckFillet(int motion, in NcMotion was, in NcMotion now)
    {
        var (first, last) = Fillet.Around(_before, motion)!.Value;
        var (before, behind) = (Flank(first - 1)!.Value, Flank(last + 1)!.Value);
        if (Wanted(first, last, before, behind) is not { } wanted)
        {
            Fail(was.Block, "no arc of the radius that the fillet must have touches the lines beside it.");
            return;
        }

        var allowed = ArcTolerance + Mismatch(was) + Math.Abs(was.Arc.Radius - _before.Motions[first].Arc.Radius);
        Measure(was.Block, Math.Abs(wanted.SignedDistance(now.PlaneStart)), allowed);
        Measure(was.Block, Math.Abs(wanted.SignedDistance(now.Arc.Middle)), allowed);
        Measure(was.Block, Math.Abs(wanted.SignedDistance(now.PlaneEnd)), allowed);
        var circle = now.Arc.Circle;
        var start = motion == first ? before.Foot(circle.Center) : circle.Center + ((was.PlaneStart - was.Center).Normalize() * circle.Radius);
        var end = motion == last ? behind.Foot(circle.Center) : circle.Center + ((was.PlaneEnd - was.Center).Normalize() * circle.Radius);
        if (now.PlaneStart.DistanceTo(start) > FootTolerance || now.PlaneEnd.DistanceTo(end) > FootTolerance)
        {
            Fail(was.Block, "the fillet does not end where it touches the lines beside it.");
        }
    }

    private Circle2? Wanted(int first, int last, Line2 before, Line2 behind)
    {
        var arc = _before.Motions[first].Arc;
        var side = arc.IsCounterClockwise ? 1 : -1;
        var offset = (_wish.Elements[_elements.IndexOf(first - 1)].End.Dot(before.Normal) + _wish.Elements[_elements.IndexOf(last + 1)].Start.Dot(behind.Normal)) / 2;
        var radius = arc.Radius - (side * offset);
        return radius > 0 && Intersect.Lines(before.Offset(side * radius), behind.Offset(side * radius)).Nearest(arc.Center) is { } center ? new(center, radius) : null;
    }

    private void CheckArc(in NcMotion was, in NcMotion now)
    {
        if (!was.IsArc)
        {
            return;
        }

        var allowed = Math.Max(Math.Max(Mismatch(was), AcceptedMismatch), 1.5 * _increment);
        if (Mismatch(now) > allowed + 1e-9)
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
        if (was.Has(MotionFlags.MachineMove))
        {
            CheckMachineMove(was, now);
            return;
        }

        if (!was.MovesInPlane || !was.IsCut)
        {
            if (!was.MovesInPlane && !KeepsItsWay(was, now) && (HeightMoved(was, now) || !LeadsAcross(motion)))
            {
                Fail(was.Block, "a move along the tool axis now moves in the plane or ends at another height.");
            }

            Note(was, NeighborRole.Positioning, moved);
            return;
        }

        if (!startMoved && !endMoved)
        {
            Fail(was.Block, "its center moved although its ends did not.");
            return;
        }

        if (was.IsArc && (!was.IsKnownInPlane || was.Has(MotionFlags.BadArc)))
        {
            Fail(was.Block, "an end of it moved, but its words do not say which arc it is.");
            return;
        }

        CheckArc(was, now);
        if (SlidAlong(was, now))
        {
            Note(was, NeighborRole.Slides, moved);
        }
        else if (startMoved && endMoved && IsFillet(motion))
        {
            CheckFillet(motion, was, now);
            Note(was, NeighborRole.Fillet, moved);
        }
        else
        {
            if (was.IsArc && moved.Length > 5 * _increment && EndsOnCircle(was, now) && !TookWish(motion, moved, endMoved))
            {
                Fail(was.Block, "its ends slid along its circle, but its center moved.");
            }

            CheckFollowingArc(was, now);
            Note(was, NeighborRole.Follows, moved);
        }

        if (!was.IsArc && (now.PlaneEnd - now.PlaneStart).Dot(was.PlaneEnd - was.PlaneStart) <= 0)
        {
            Fail(was.Block, "it turned round.");
        }
    }

    // An arc whose ends moved alike moved as a whole; another runs through its old middle moved by half of what its ends moved.
    private void CheckFollowingArc(in NcMotion was, in NcMotion now)
    {
        if (!was.IsArc)
        {
            return;
        }

        var (start, end) = (now.PlaneStart - was.PlaneStart, now.PlaneEnd - was.PlaneEnd);
        if ((start - end).Length < 1e-9)
        {
            Measure(was.Block, (now.Center - was.Center - start).Length, 1e-6);
            return;
        }

        var middle = was.PlaneAt(0.5) + ((start + end) / 2);
        if (!(now.Has(MotionFlags.ByRadius) && HasFittingRadius(was, now, middle)))
        {
            Measure(was.Block, Math.Abs(now.Arc.Circle.SignedDistance(middle)), ArcTolerance + Mismatch(was));
        }
    }

    // Near half a turn a radius that is right to an increment leaves the middle of the arc wherever the rounding puts it.
    private bool HasFittingRadius(in NcMotion was, in NcMotion now, Point2 middle)
    {
        if (Math.Abs(now.Arc.Radius - was.Arc.Radius) < 1e-6 && Math.Abs(now.Arc.Sweep.Radians - was.Arc.Sweep.Radians) < 0.02 * Math.Abs(was.Arc.Sweep.Radians))
        {
            return true;
        }

        return CircleThrough(now.PlaneStart, middle, now.PlaneEnd) is { } circle
            && Math.Abs(now.Arc.Radius - circle.Radius) <= (1.5 * _increment) + 1e-6;
    }

    // Null for points on one line: no circle is right.
    private static Circle2? CircleThrough(Point2 start, Point2 middle, Point2 end)
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

    // A block that runs several times is one neighbor, named with the furthest that it moved.
    private void Note(in NcMotion was, NeighborRole role, Vector2 moved)
    {
        if (_noted.TryAdd((was.Block, role), _neighbors.Count))
        {
            _neighbors.Add(new(_before.Program.NameOf(_before.Program[was.Block]), was.Block + 1, role, moved.Length));
            return;
        }

        var noted = _noted[(was.Block, role)];
        _neighbors[noted] = _neighbors[noted] with { DisplacementMm = Math.Max(_neighbors[noted].DisplacementMm, moved.Length) };
    }

    private bool EndsOnCircle(in NcMotion was, in NcMotion now)
    {
        var circle = was.Arc.Circle;
        return Math.Abs(circle.SignedDistance(now.PlaneStart)) <= ArcTolerance + Mismatch(was) && Math.Abs(circle.SignedDistance(now.PlaneEnd)) <= ArcTolerance + Mismatch(was);
    }

    private bool SlidAlong(in NcMotion was, in NcMotion now)
    {
        if (was.IsArc)
        {
            return now.Center.DistanceTo(was.Center) <= 3 * _increment && EndsOnCircle(was, now);
        }

        if (was.PlaneStart == was.PlaneEnd)
        {
            // It begins or ends where the program does not say, so nothing shows along which line.
            return false;
        }

        var line = was.Segment.Line;
        return Math.Abs(line.SignedDistance(now.PlaneStart)) <= LineTolerance && Math.Abs(line.SignedDistance(now.PlaneEnd)) <= LineTolerance;
    }
}
