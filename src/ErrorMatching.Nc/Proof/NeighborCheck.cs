namespace ErrorMatching.Nc;

/// <summary>Checks unnamed motions that moved along: those next to a named one, and those between cuts.</summary>
internal sealed class NeighborCheck(ProofTask task, ProofFindings findings, WayCheck ways, ArcCheck arcs, FilletCheck fillets)
{
    public void Check(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var moved = endMoved ? now.PlaneEnd - was.PlaneEnd : now.PlaneStart - was.PlaneStart;
        if (was.Has(MotionFlags.MachineMove))
        {
            ways.CheckMachineMove(was, now);
            return;
        }

        if (!was.MovesInPlane || !was.IsCut)
        {
            if (!was.MovesInPlane && !WayCheck.KeepsItsWay(was, now) && (WayCheck.HeightMoved(was, now) || !ways.LeadsAcross(motion)))
            {
                findings.Fail(was.Block, "a move along the tool axis now moves in the plane or ends at another height.");
            }

            findings.Note(was, now, NeighborRole.Positioning);
            return;
        }

        if (!startMoved && !endMoved)
        {
            findings.Fail(was.Block, "its center moved although its ends did not.");
            return;
        }

        if (was.IsArc && (!was.IsKnownInPlane || was.Has(MotionFlags.BadArc)))
        {
            findings.Fail(was.Block, "an end of it moved, but its words do not say which arc it is.");
            return;
        }

        if (was.IsLeadArc)
        {
            arcs.CheckVertical(was, now, ways.IsHeldOnBothSides(motion));
            findings.Note(was, NeighborRole.Follows, WayCheck.Moved(was, now));
            return;
        }

        arcs.CheckWords(was, now);

        // Also if only one of its ends moved, or both along its circle: the lines beside it are free to end anywhere on it.
        var isFillet = fillets.Is(motion);
        if (isFillet)
        {
            fillets.Check(motion, was, now);
        }

        if (SlidAlong(was, now))
        {
            findings.Note(was, now, NeighborRole.Slides);
        }
        else if (isFillet)
        {
            findings.Note(was, now, NeighborRole.Fillet);
        }
        else
        {
            if (was.IsArc && moved.Length > 5 * task.Increment && arcs.EndsOnCircle(was, now) && !ways.TookWish(motion, moved, endMoved))
            {
                findings.Fail(was.Block, "its ends slid along its circle, but its center moved.");
            }

            arcs.CheckFollowing(was, now, ways.WishAt(motion, atEnd: false), ways.WishAt(motion, atEnd: true));
            findings.Note(was, now, NeighborRole.Follows);
        }

        if (!was.IsArc && (now.PlaneEnd - now.PlaneStart).Dot(was.PlaneEnd - was.PlaneStart) <= 0)
        {
            findings.Fail(was.Block, "it turned round.");
        }
    }

    private bool SlidAlong(in NcMotion was, in NcMotion now)
    {
        if (was.IsArc)
        {
            return ProofTask.Furthest(now, was.Arc.Circle) <= task.ArcTolerance + ProofTask.Mismatch(was);
        }

        if (was.PlaneStart == was.PlaneEnd)
        {
            // Its start or end is unknown, so its line is unknown too.
            return false;
        }

        var line = was.Segment.Line;
        return Math.Abs(line.SignedDistance(now.PlaneStart)) <= task.LineTolerance
            && Math.Abs(line.SignedDistance(now.PlaneEnd)) <= task.LineTolerance;
    }
}
