using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Joints that are the same place of the piece because a contour closes there. A later cut ends where a run begins, an earlier
/// cut begins where a run ends, or a ring inside a run returns to its own joint.</summary>
internal sealed class ClosedContours
{
    /// <summary>Smallest distance between the unit directions before and after a joint that makes it a corner: a turn of 5.7 degrees. A
    /// full reversal is 2.</summary>
    private const double CornerTurn = 0.0996;

    private readonly ProofTask _task;
    private readonly Dictionary<int, int> _otherEnds = [];

    public ClosedContours(ProofTask task, WayCheck ways)
    {
        _task = task;
        var motions = task.Before.Motions;
        var contours = new ContourSearch(motions, ProofTask.SamePlace, task.Elements.Count, ways.IsPassed);
        for (var run = 0; run < task.Elements.Count; run++)
        {
            var (first, last) = task.Elements[run];
            var (start, end) = (motions.StartOf(first), motions.EndOf(last));
            var closing = ProofTask.Same(motions.EndOf(first), start) ? first
                : IsLead(first) ? -1 : contours.FirstEndingAt(start, first + 1, first);
            if (closing >= 0)
            {
                _otherEnds[first] = closing + 1;
                _otherEnds.TryAdd(closing + 1, first);
            }

            var opening = ProofTask.Same(motions.StartOf(last), end) ? last
                : IsLead(last) ? -1 : contours.LastStartingAt(end, last - 1, last);
            if (opening >= 0)
            {
                _otherEnds[last + 1] = opening;
                _otherEnds.TryAdd(opening, last + 1);
            }

            AddRings(first, last);
        }
    }

    /// <summary>All joints that share their place with another.</summary>
    public IReadOnlyCollection<int> Joints => _otherEnds.Values;

    /// <summary>The other joint at the same place of the piece; -1 if there is none.</summary>
    public int OtherEnd(int joint) => _otherEnds.TryGetValue(joint, out var other) ? other : -1;

    // A way in or out on which cutter compensation is switched begins or ends where the tool's center is, not on a contour.
    private bool IsLead(int motion) => _task.Before.Motions.SwitchesCompensation(motion);

    // Inner joints of a run to which it returns, and where it turns at least once or makes a full circle. Two paths that cross smoothly
    // need not keep crossing.
    private void AddRings(int first, int last)
    {
        var motions = _task.Before.Motions;
        var lastAt = new Dictionary<Point3, int>();
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (Turns(joint) || motions.StartOf(joint) == motions.EndOf(joint))
            {
                lastAt[motions.StartOf(joint)] = -1;
            }
        }

        for (var joint = first + 1; joint <= last; joint++)
        {
            var place = motions.StartOf(joint);
            if (!lastAt.TryGetValue(place, out var before))
            {
                continue;
            }

            if (before >= 0)
            {
                (_otherEnds[before], _otherEnds[joint]) = (joint, before);
            }

            lastAt[place] = joint;
        }
    }

    private bool Turns(int joint)
    {
        var (before, behind) = (_task.Before.Motions[joint - 1], _task.Before.Motions[joint]);
        return before.Plane == behind.Plane && HasDirection(before) && HasDirection(behind)
            && (before.TangentAt(1) - behind.TangentAt(0)).Length > CornerTurn;
    }

    // An arc that begins or ends in its own center has none, but no element that is one is proved.
    private static bool HasDirection(in NcMotion motion) => motion is { MovesInPlane: true, IsCut: true };
}
