using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks moved end points: all move by one vector, or each by its own. Retracts after them move in the plane only, and arcs
/// move with their ends.</summary>
internal sealed class EndPointCheck(ProofTask task, ProofFindings findings, WayCheck ways, ArcCheck arcs)
{
    public void Check(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var plane = was.Plane;
        var moved = now.End - was.End;
        if (task.EndPoints.IndexOf(motion) is >= 0 and var index)
        {
            var off = moved - task.Wish.ByOf(index);
            var furthest = Math.Max(Math.Abs(off.X), Math.Max(Math.Abs(off.Y), Math.Abs(off.Z)));
            findings.Measure(was.Block, furthest, (0.5 * task.Increment) + 1e-6);
        }
        else if (task.Wish.IsPointByPoint && endMoved)
        {
            findings.Fail(was.Block, "it moved although it was not named.");
        }
        else if (task.Wish.IsPointByPoint && startMoved)
        {
            findings.Note(was, now, NeighborRole.Follows);
        }
        else if ((startMoved || endMoved) && was.Has(MotionFlags.MachineMove))
        {
            ways.CheckMachineMove(was, now);
        }
        else if ((startMoved || endMoved) && was.IsLeadArc)
        {
            findings.Note(was, NeighborRole.Follows, WayCheck.Moved(was, now));
        }
        else if (startMoved || endMoved)
        {
            // Only before a vertical arc does the way end at another height: that arc keeps its form.
            var isRetract = !was.MovesInPlane;
            var isBeforeArc = motion + 1 < task.Before.Motions.Length && task.Before.Motions.IsLeadArc(motion + 1);
            if ((isRetract && !ProofTask.Same(now.PlaneStart, now.PlaneEnd) && !ways.LeadsAcross(motion))
                || (Math.Abs(plane.Height(default(Point3) + moved)) > 1e-9 && !isBeforeArc))
            {
                findings.Fail(was.Block, "a move along the tool axis now moves in the plane or ends at another height.");
            }

            findings.Note(was, now, isRetract ? NeighborRole.Positioning : NeighborRole.Follows);
        }

        if (was.IsLeadArc)
        {
            arcs.CheckVertical(was, now, task.Wish.IsPointByPoint || ways.IsHeldOnBothSides(motion));
            return;
        }

        arcs.CheckWords(was, now);
        arcs.CheckFollowing(was, now, WishOf(motion - 1, plane), WishOf(motion, plane));
    }

    private Vector2? WishOf(int motion, CoordinatePlane plane) => task.EndPoints.IndexOf(motion) is >= 0 and var index
        ? plane.Project(default(Point3) + task.Wish.ByOf(index)) - Point2.Origin
        : null;
}
