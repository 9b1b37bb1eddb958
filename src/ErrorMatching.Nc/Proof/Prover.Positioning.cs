using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// What is between one cut and the next: steps in depth at a corner, the ways along the tool axis on which the tool is lifted, and moves to
/// places of the machine. What a moved joint takes along, and what must stay.
/// </content>
public sealed partial class Prover
{
    // Joints that positioning shares with those that are allowed already: what one reaches, the next would reach as well, so each way is
    // gone once. A cut at the end of the way shares its joint only where the tool was not lifted on it.
    private void AllowPositioning(bool[] allowed)
    {
        var motions = _before.Motions;
        var joint = Array.IndexOf(allowed, true);
        for (; joint >= 0 && joint < motions.Length; joint = Array.IndexOf(allowed, true, joint + 1))
        {
            allowed[joint + 1] |= motions[joint].Has(MotionFlags.MachineMove)
                || (!motions.MovesInPlane(joint) && !IsLiftedBefore(joint + 1));
        }

        joint = _elements.Count > 0 ? Array.LastIndexOf(allowed, true) : 0;
        for (; joint > 0; joint = Array.LastIndexOf(allowed, true, joint - 1))
        {
            allowed[joint - 1] |= !motions.MovesInPlane(joint - 1) && !IsLiftedBehind(joint - 1);
        }
    }

    // The cut that begins at a joint, and was not named, was reached along the tool axis and not by feeds of one tool alone.
    private bool IsLiftedBefore(int joint)
    {
        var motions = _before.Motions;
        if (!IsCutInPlane(joint) || _endPoints.Contains(joint))
        {
            return false;
        }

        var isLifted = _before.ChangesTool(joint, joint);
        for (var i = joint - 1; i >= 0 && !motions.MovesInPlane(i) && !isLifted; i--)
        {
            isLifted = motions[i].Kind != MotionKind.Line || _before.ChangesTool(i, i);
        }

        return isLifted;
    }

    // The cut that ends at a joint was left along the tool axis and not by feeds of one tool alone.
    private bool IsLiftedBehind(int joint)
    {
        var motions = _before.Motions;
        if (!IsCutInPlane(joint - 1))
        {
            return false;
        }

        var isLifted = _before.ChangesTool(joint, joint);
        for (var i = joint; i < motions.Length && !motions.MovesInPlane(i) && !isLifted; i++)
        {
            isLifted = motions[i].Kind != MotionKind.Line || _before.ChangesTool(i + 1, i + 1);
        }

        return isLifted;
    }

    // The joint of a cut that nobody named, at which the tool was changed.
    private bool IsOtherTools(int motion, int joint) =>
        _before.ChangesTool(joint, joint) && IsCutInPlane(motion) && !_elements.Contains(motion) && !_endPoints.Contains(motion);

    private bool IsCutInPlane(int motion) =>
        motion >= 0 && motion < _before.Motions.Length && _before.Motions[motion] is { IsCut: true, MovesInPlane: true };

    /// <summary>
    /// True for the rapid that leads from the place of one cut to that of another which was the same and no longer is: the tool was lifted
    /// or changed before it, and nothing else on the way from the one to the other goes anywhere in the plane.
    /// </summary>
    private bool LeadsAcross(int rapid)
    {
        var was = _before.Motions[rapid];
        if (was.Kind != MotionKind.Rapid || was.Has(MotionFlags.MachineMove)
            || (rapid > 0 && _before.Motions[rapid - 1].IsCut && !_before.ChangesTool(rapid, rapid)))
        {
            return false;
        }

        var (first, last) = (rapid, rapid);
        while (first > 0 && IsAlongAxis(first - 1))
        {
            first--;
        }

        while (last + 1 < _before.Motions.Length && IsAlongAxis(last + 1))
        {
            last++;
        }

        var isHeld = IsCutInPlane(first - 1)
            || (first > 0 && (_before.Motions[first - 1].Has(MotionFlags.MachineMove) || _endPoints.Contains(first - 1)));
        for (var i = first; i <= last; i++)
        {
            isHeld &= i == rapid || Same(_after.Motions[i].PlaneStart, _after.Motions[i].PlaneEnd);
        }

        return isHeld && IsCutInPlane(last + 1);
    }

    private bool IsAlongAxis(int motion) => !_before.Motions.MovesInPlane(motion) && !_endPoints.Contains(motion);

    private static bool KeepsItsWay(in NcMotion was, in NcMotion now) =>
        Same(default(Point3) + (now.Start - was.Start), default(Point3) + (now.End - was.End));

    private static bool HeightMoved(in NcMotion was, in NcMotion now) =>
        Math.Abs(was.Plane.Height(now.Start) - was.Plane.Height(was.Start)) > SamePlace
        || Math.Abs(was.Plane.Height(now.End) - was.Plane.Height(was.End)) > SamePlace;

    // It ends in each axis where it did: at the place of the machine, or as much elsewhere as it began, where it says nothing of the axis.
    private void CheckMachineMove(in NcMotion was, in NcMotion now)
    {
        var (start, end) = (now.Start - was.Start, now.End - was.End);
        if (!StaysOrGoesAlong(start.X, end.X) || !StaysOrGoesAlong(start.Y, end.Y) || !StaysOrGoesAlong(start.Z, end.Z))
        {
            Fail(was.Block, "a move to a place of the machine ends neither there nor where it comes from.");
        }

        Note(was, NeighborRole.Positioning, was.Plane.Project(default(Point3) + (end == Vector3.Zero ? start : end)) - Point2.Origin);
    }

    private static bool StaysOrGoesAlong(double start, double end) => Math.Abs(end) <= SamePlace || Math.Abs(end - start) <= SamePlace;

    // Motions that go nowhere in the plane and do not part the cuts on both sides of them.
    private bool IsPassed(int motion) => PathWithoutPoints.IsPoint(_before.Motions[motion]) || IsStep(motion);

    // A feed along the tool axis from one named element to the next: a step in depth at their corner.
    private bool IsStep(int motion)
    {
        var (before, behind) = (motion, motion);
        while (before >= 0 && IsFeedAlongAxis(before))
        {
            before--;
        }

        while (behind < _before.Motions.Length && IsFeedAlongAxis(behind))
        {
            behind++;
        }

        return before < motion && motion < behind && _elements.Contains(before) && _elements.Contains(behind)
            && _before.Motions.IsComparable(before, behind);
    }

    private bool IsFeedAlongAxis(int motion) =>
        !_before.Motions.MovesInPlane(motion) && _before.Motions[motion] is { Kind: MotionKind.Line } m && !m.Has(MotionFlags.MachineMove);

    // An end that was asked to go a way that happens to lie along the circle of an arc is not one that slid: something along the tool axis
    // is between the named element and the arc.
    private bool TookWish(int motion, Vector2 moved, bool atEnd)
    {
        var beside = atEnd ? motion + 1 : motion - 1;
        while (beside >= 0 && beside < _before.Motions.Length && !_before.Motions.MovesInPlane(beside))
        {
            beside += atEnd ? 1 : -1;
        }

        return Math.Abs(beside - motion) > 1 && _elements.IndexOf(beside) is >= 0 and var index
            && (moved - (atEnd ? _wish.Elements[index].Start : _wish.Elements[index].End)).Length <= _increment + 1e-6;
    }
}
