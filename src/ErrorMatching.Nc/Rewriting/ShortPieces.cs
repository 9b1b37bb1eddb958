using System.Collections;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Short pieces of polylines that a corner cuts off: they shrink to the corner.</summary>
internal sealed class ShortPieces(PathChange change)
{
    private readonly BitArray _smoothJoints = new(change.Path.Motions.Length + 1);
    private readonly HashSet<int> _shrunk = [];

    /// <summary>True if a motion has shrunk to a point.</summary>
    public bool AreShrunk(int motion) => _shrunk.Contains(motion);

    /// <summary>Notes that two pieces of a polyline meet at a joint.</summary>
    public void AddSmooth(int joint) => _smoothJoints[joint] = true;

    /// <summary>True if a displaced line of a polyline is wholly on the wrong side of a corner and a neighbor in the same polyline can
    /// replace it.</summary>
    public bool EndsBefore(int element, Point2 corner, bool atStart)
    {
        var motion = change.Path.Motions[element];
        var joint = atStart ? element : element + 1;
        if (motion.IsArc || !_smoothJoints[joint])
        {
            return false;
        }

        var far = (atStart ? motion.PlaneStart : motion.PlaneEnd) + change.PlaneMoveOf(joint, motion.Plane);
        var beyond = (corner - far).Dot(motion.PlaneEnd - motion.PlaneStart);
        return atStart ? beyond <= 0 : beyond >= 0;
    }

    /// <summary>Moves all joints from one to another to one point; the lines between them get length zero.</summary>
    public void Shrink(int firstJoint, int lastJoint, Point2 point)
    {
        var motions = change.Path.Motions;
        var plane = motions[Math.Min(firstJoint, motions.Length - 1)].Plane;
        for (var joint = firstJoint; joint <= lastJoint; joint++)
        {
            change.Move(joint, plane, point - (joint < motions.Length ? motions[joint].PlaneStart : motions[joint - 1].PlaneEnd));
        }

        for (var motion = firstJoint; motion < lastJoint; motion++)
        {
            _shrunk.Add(motion);
        }
    }
}
