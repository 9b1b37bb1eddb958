using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks motions between cuts: steps in depth at a corner, moves along the tool axis that lift the tool, and moves to machine
/// positions. Finds what moves with a joint and what must stay.</summary>
internal sealed class WayCheck(ProofTask task, ProofFindings findings)
{
    /// <summary>Centers and radii that differ by less are one circle, mm.</summary>
    private const double SameCircle = 0.01;

    private bool[] _allowed = [];

    // Allows joints that positioning shares with allowed joints. The loop passes newly allowed joints too, so one pass is enough. A cut
    // at the end of the positioning shares its joint only if the tool was not lifted before it.
    public void AllowPositioning(bool[] allowed)
    {
        _allowed = allowed;
        var motions = task.Before.Motions;
        var joint = Array.IndexOf(allowed, true);
        for (; joint >= 0 && joint < motions.Length; joint = Array.IndexOf(allowed, true, joint + 1))
        {
            allowed[joint + 1] |= motions[joint].Has(MotionFlags.MachineMove) || (GoesAlong(joint) && !IsLiftedBefore(joint + 1));
        }

        joint = task.Elements.Count > 0 ? Array.LastIndexOf(allowed, true) : 0;
        for (; joint > 0; joint = Array.LastIndexOf(allowed, true, joint - 1))
        {
            allowed[joint - 1] |= GoesAlong(joint - 1) && !IsLiftedBehind(joint - 1);
        }

        foreach (var arc in task.Wish.IsPointByPoint ? [] : task.Wish.EndPoints)
        {
            for (joint = motions.IsLeadArc(arc) ? arc + 1 : 0; joint > 0 && GoesAlong(joint - 1) && !IsLiftedBehind(joint - 1); joint--)
            {
                allowed[joint - 1] = true;
            }
        }
    }

    /// <summary>True if a vertical arc lies between two places of which each is named or stays: then it may become another one.</summary>
    public bool IsHeldOnBothSides(int arc)
    {
        if (!task.Before.Motions.IsVertical(arc))
        {
            return false;
        }

        var (first, end) = (arc, arc + 1);
        while (first > 0 && GoesAlong(first - 1) && !task.EndPoints.Contains(first - 1))
        {
            first--;
        }

        while (end < task.Before.Motions.Length && GoesAlong(end) && !task.EndPoints.Contains(end - 1))
        {
            end++;
        }

        return IsHeld(first, first - 1) && IsHeld(end, end);
    }

    private bool IsHeld(int joint, int motion) =>
        !_allowed[joint] || task.Elements.Contains(motion) || task.EndPoints.Contains(joint - 1);

    // Motions along the tool axis, vertical arcs and helices: these keep their form, so both of their ends move.
    private bool GoesAlong(int motion) => !task.Before.Motions.MovesInPlane(motion)
        || (task.Before.Motions.IsLeadArc(motion) && !IsOnNamedCircle(motion));

    // A helix that cuts the wall of a named arc cannot move aside.
    private bool IsOnNamedCircle(int motion)
    {
        var motions = task.Before.Motions;
        var (helix, first, last) = (motions[motion], motion, motion);
        while (helix.IsHelixToAngle && first > 0 && motions[first].IsHelixToAngle)
        {
            first--;
        }

        while (helix.IsHelixToAngle && last + 1 < motions.Length && motions[last].IsHelixToAngle)
        {
            last++;
        }

        return helix.IsHelixToAngle && (IsNamedOn(helix, first) || IsNamedOn(helix, last));
    }

    private bool IsNamedOn(in NcMotion helix, int motion) => task.Elements.Contains(motion)
        && task.Before.Motions[motion] is { IsArc: true } arc && arc.Center.DistanceTo(helix.Center) < SameCircle
        && Math.Abs(arc.PlaneStart.DistanceTo(arc.Center) - helix.PlaneStart.DistanceTo(helix.Center)) < SameCircle;

    // An unnamed cut begins at the joint, and it was reached along the tool axis, not by feeds of one tool alone.
    private bool IsLiftedBefore(int joint)
    {
        var motions = task.Before.Motions;
        if (!task.IsCutInPlane(joint) || task.EndPoints.Contains(joint))
        {
            return false;
        }

        var isLifted = task.Before.ChangesTool(joint, joint);
        var first = joint;
        for (; first > 0 && GoesAlong(first - 1); first--)
        {
            isLifted |= motions[first - 1].Kind != MotionKind.Line || task.Before.ChangesTool(first - 1, first - 1);
        }

        return isLifted && !(HasLeadArc(first, joint) && motions.PlaceOf(joint).Z > motions.PlaceOf(first).Z);
    }

    // The cut that ends at the joint was left along the tool axis, not by feeds of one tool alone.
    private bool IsLiftedBehind(int joint)
    {
        var motions = task.Before.Motions;
        if (!task.IsCutInPlane(joint - 1))
        {
            return false;
        }

        var isLifted = task.Before.ChangesTool(joint, joint);
        var end = joint;
        for (; end < motions.Length && GoesAlong(end); end++)
        {
            isLifted |= motions[end].Kind != MotionKind.Line || task.Before.ChangesTool(end + 1, end + 1);
        }

        return isLifted && !(HasLeadArc(joint, end) && motions.PlaceOf(joint).Z > motions.PlaceOf(end).Z);
    }

    // An arc that leads down to the contour was reached above it, where a cut may end elsewhere.
    private bool HasLeadArc(int first, int end)
    {
        for (var i = first; i < end; i++)
        {
            if (task.Before.Motions.IsLeadArc(i))
            {
                return true;
            }
        }

        return false;
    }

    // The joint of an unnamed cut, with a tool change at that joint.
    public bool IsOtherTools(int motion, int joint) =>
        task.Before.ChangesTool(joint, joint) && task.IsCutInPlane(motion)
        && !task.Elements.Contains(motion) && !task.EndPoints.Contains(motion);

    /// <summary>True for a rapid between two cuts that shared a place in the plane and no longer do. The tool was lifted or changed
    /// before it, and no other motion between the cuts moves in the plane.</summary>
    public bool LeadsAcross(int rapid)
    {
        var was = task.Before.Motions[rapid];
        if (was.Kind != MotionKind.Rapid || was.Has(MotionFlags.MachineMove)
            || (rapid > 0 && task.Before.Motions[rapid - 1].IsCut && !task.Before.ChangesTool(rapid, rapid)))
        {
            return false;
        }

        var (first, last) = (rapid, rapid);
        while (first > 0 && (IsAlongAxis(first - 1) || task.Before.Motions.IsLeadArc(first - 1)))
        {
            first--;
        }

        while (last + 1 < task.Before.Motions.Length && (IsAlongAxis(last + 1) || task.Before.Motions.IsLeadArc(last + 1)))
        {
            last++;
        }

        var isHeld = task.IsCutInPlane(first - 1)
            || (first > 0 && (task.Before.Motions[first - 1].Has(MotionFlags.MachineMove) || task.EndPoints.Contains(first - 1)));
        for (var i = first; i <= last; i++)
        {
            isHeld &= i == rapid || task.Before.Motions.IsLeadArc(i)
                || ProofTask.Same(task.After.Motions[i].PlaneStart, task.After.Motions[i].PlaneEnd);
        }

        return isHeld && task.IsCutInPlane(last + 1);
    }

    private bool IsAlongAxis(int motion) => !task.Before.Motions.MovesInPlane(motion) && !task.EndPoints.Contains(motion);

    /// <summary>How far the ends of a motion went at most in space, mm.</summary>
    public static double Moved(in NcMotion was, in NcMotion now) => Math.Max((now.Start - was.Start).Length, (now.End - was.End).Length);

    public static bool KeepsItsWay(in NcMotion was, in NcMotion now) =>
        ProofTask.Same(default(Point3) + (now.Start - was.Start), default(Point3) + (now.End - was.End));

    public static bool HeightMoved(in NcMotion was, in NcMotion now) =>
        Math.Abs(was.Plane.Height(now.Start) - was.Plane.Height(was.Start)) > ProofTask.SamePlace
        || Math.Abs(was.Plane.Height(now.End) - was.Plane.Height(was.End)) > ProofTask.SamePlace;

    // In each axis it ends where it did (at the machine position), or moved by as much as its start if it does not name the axis.
    public void CheckMachineMove(in NcMotion was, in NcMotion now)
    {
        var (start, end) = (now.Start - was.Start, now.End - was.End);
        if (!StaysOrGoesAlong(start.X, end.X) || !StaysOrGoesAlong(start.Y, end.Y) || !StaysOrGoesAlong(start.Z, end.Z))
        {
            findings.Fail(was.Block, "a move to a place of the machine ends neither there nor where it comes from.");
        }

        var moved = was.Plane.Project(default(Point3) + (end == Vector3.Zero ? start : end));
        findings.Note(was, NeighborRole.Positioning, moved.DistanceTo(Point2.Origin));
    }

    private static bool StaysOrGoesAlong(double start, double end) =>
        Math.Abs(end) <= ProofTask.SamePlace || Math.Abs(end - start) <= ProofTask.SamePlace;

    // Motions that do not move in the plane and do not separate the cuts on either side.
    public bool IsPassed(int motion) => IsNowhere(motion) || IsStep(motion);

    // A straight cut whose end equals its start exactly.
    private bool IsNowhere(int motion) =>
        task.Before.Motions[motion] is { Kind: MotionKind.Line } m && m.End - m.Start == Vector3.Zero;

    // A feed along the tool axis between two named elements: a step in depth at their corner.
    private bool IsStep(int motion)
    {
        var (before, behind) = (motion, motion);
        while (before >= 0 && IsFeedAlongAxis(before))
        {
            before--;
        }

        while (behind < task.Before.Motions.Length && IsFeedAlongAxis(behind))
        {
            behind++;
        }

        return before < motion && task.Elements.Contains(before) && task.Elements.Contains(behind)
            && task.Before.Motions.IsComparable(before, behind);
    }

    private bool IsFeedAlongAxis(int motion) =>
        !task.Before.Motions.MovesInPlane(motion)
        && task.Before.Motions[motion] is { Kind: MotionKind.Line } m && !m.Has(MotionFlags.MachineMove);

    // The wished displacement of an end may happen to follow the circle of an arc. The arc did not slide if a move along the tool axis
    // separates it from the named element.
    public bool TookWish(int motion, Vector2 moved, bool atEnd) =>
        Math.Abs(Beside(motion, atEnd) - motion) > 1 && WishAt(motion, atEnd) is { } wished
            && (moved - wished).Length <= task.Increment + 1e-6;

    /// <summary>What is wished for the start of the named element behind a motion, or for the end of the one before it, across moves along
    /// the tool axis; null if there is none.</summary>
    public Vector2? WishAt(int motion, bool atEnd) => task.Elements.IndexOf(Beside(motion, atEnd)) is >= 0 and var index
        ? atEnd ? task.Wish.Elements[index].Start : task.Wish.Elements[index].End
        : null;

    private int Beside(int motion, bool atEnd)
    {
        var beside = atEnd ? motion + 1 : motion - 1;
        while (beside >= 0 && beside < task.Before.Motions.Length && !task.Before.Motions.MovesInPlane(beside))
        {
            beside += atEnd ? 1 : -1;
        }

        return beside;
    }
}
