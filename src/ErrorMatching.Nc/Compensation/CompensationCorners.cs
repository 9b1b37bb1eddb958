using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Leads the tool's center around outside corners.</summary>
/// <param name="rule">The control.</param>
/// <param name="modes">Its modes.</param>
/// <param name="trace">The tool's center.</param>
internal sealed class CompensationCorners(CompensationRule rule, CompensationModes modes, CenterTrace trace)
{
    private readonly double _straightSine = Elementary.Sin(rule.StraightDegrees * Math.PI / 180);
    private readonly double _sharpCosine = Elementary.Cos(rule.SharpDegrees * Math.PI / 180) - 1e-9;

    /// <summary>How the contour turns from one element to the next, seen from the tool.</summary>
    /// <param name="last">The element before the corner.</param>
    /// <param name="next">The element after it.</param>
    /// <param name="left">Distance of the tool's center to the left, mm.</param>
    public CornerKind KindOf(in OffsetElement last, in OffsetElement next, double left)
    {
        var sine = last.EndTangent.Cross(next.StartTangent);
        if (Math.Abs(sine) <= _straightSine)
        {
            // Where the contour turns back, the tool goes around its end. If it goes around the outside of an arc there, both paths meet.
            var arc = next.IsArc ? next : last;
            return last.EndTangent.Dot(next.StartTangent) > 0 ? CornerKind.Straight
                : arc.IsArc && arc.IsCounterClockwise != left > 0 ? CornerKind.Inside
                : CornerKind.Outside;
        }

        return sine > 0 == left > 0 ? CornerKind.Inside : CornerKind.Outside;
    }

    /// <summary>Moves the end of the last element at an outside corner as far as the control goes on along it.</summary>
    /// <param name="last">The element before the corner.</param>
    /// <param name="next">The element after it.</param>
    /// <param name="left">Distance of the tool's center to the left, mm.</param>
    /// <returns>What is still to be inserted: <see cref="CompensationCorner.Intersection"/> for nothing.</returns>
    public CompensationCorner GoOn(in OffsetElement last, in OffsetElement next, double left)
    {
        var corner = modes.IsSharpAtEndOf(last.Motion) ? CompensationCorner.Intersection
            : last.EndTangent.Dot(next.StartTangent) < _sharpCosine ? modes.SharpCorners
            : modes.Corners;
        if (corner == CompensationCorner.Intersection)
        {
            if (last.Meet(next) is not { } meeting)
            {
                return CompensationCorner.Arc;
            }

            trace.MoveEnd(meeting);
        }
        else if (corner == CompensationCorner.Pieces && !last.IsArc)
        {
            trace.MoveEnd(last.End + (last.EndTangent * Math.Abs(left)));
        }

        return corner;
    }

    /// <summary>Inserts the rest of an outside corner.</summary>
    /// <param name="corner">How.</param>
    /// <param name="last">The element before the corner.</param>
    /// <param name="next">The element after it.</param>
    /// <param name="left">Distance of the tool's center to the left, mm.</param>
    /// <param name="motion">The programmed motion after it.</param>
    public void Insert(CompensationCorner corner, in OffsetElement last, in OffsetElement next, double left, in NcMotion motion)
    {
        var (after, reach) = (next.Start, Math.Abs(left));
        if (corner == CompensationCorner.Arc)
        {
            // At rapid, a straight move cuts the corner short.
            var turn = left > 0 ? MotionKind.ArcClockwise : MotionKind.ArcCounterClockwise;
            Insert(next.Motion, motion, motion.Kind == MotionKind.Rapid ? MotionKind.Rapid : turn, after, last.ProgrammedEnd);
        }
        else if (corner == CompensationCorner.Pieces)
        {
            var straight = motion.Kind == MotionKind.Rapid ? MotionKind.Rapid : MotionKind.Line;
            if (last.IsArc)
            {
                Insert(next.Motion, motion, straight, last.End + (last.EndTangent * reach), default);
            }

            Insert(next.Motion, motion, straight, after - (next.StartTangent * reach), default);
            if (next.IsArc)
            {
                Insert(next.Motion, motion, straight, after, default);
            }
        }
    }

    private void Insert(int index, in NcMotion motion, MotionKind kind, Point2 end, Point2 center) => trace.Add(new(
        index,
        kind,
        motion.Plane,
        true,
        true,
        trace.At,
        motion.Plane.Lift(end, motion.Plane.Height(trace.At)),
        center,
        0,
        trace.UnknownAt));
}

/// <summary>How a contour turns, seen from the tool.</summary>
internal enum CornerKind
{
    /// <summary>It goes straight on.</summary>
    Straight,

    /// <summary>Toward the tool.</summary>
    Inside,

    /// <summary>Away from the tool.</summary>
    Outside,
}
