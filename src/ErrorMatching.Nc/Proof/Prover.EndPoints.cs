using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Moved end points: the named ones by the vector, or each by its own; retracts behind them in the plane only, arcs with their ends.</content>
public sealed partial class Prover
{
    private void CheckEndPoint(int motion, in NcMotion was, in NcMotion now, bool startMoved, bool endMoved)
    {
        var plane = was.Plane;
        var moved = now.End - was.End;
        if (_endPoints.IndexOf(motion) is >= 0 and var index)
        {
            var off = moved - _wish.ByOf(index);
            Measure(was.Block, Math.Max(Math.Abs(off.X), Math.Max(Math.Abs(off.Y), Math.Abs(off.Z))), (0.5 * _increment) + 1e-6);
        }
        else if (_wish.IsPointByPoint && endMoved)
        {
            Fail(was.Block, "it moved although it was not named.");
        }
        else if (_wish.IsPointByPoint && startMoved)
        {
            Note(was, NeighborRole.Follows, now.PlaneStart - was.PlaneStart);
        }
        else if ((startMoved || endMoved) && was.Has(MotionFlags.MachineMove))
        {
            CheckMachineMove(was, now);
        }
        else if (startMoved || endMoved)
        {
            var isRetract = !was.MovesInPlane;
            if ((isRetract && !Same(now.PlaneStart, now.PlaneEnd) && !LeadsAcross(motion))
                || Math.Abs(plane.Height(default(Point3) + moved)) > 1e-9)
            {
                Fail(was.Block, "a move along the tool axis now moves in the plane or ends at another height.");
            }

            Note(was, isRetract ? NeighborRole.Positioning : NeighborRole.Follows, endMoved ? now.PlaneEnd - was.PlaneEnd : now.PlaneStart - was.PlaneStart);
        }

        CheckArc(was, now);
        CheckFollowingArc(was, now);
    }
}
