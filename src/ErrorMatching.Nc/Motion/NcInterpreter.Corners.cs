using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Corner words: a rounding or a chamfer between the motion that has the word and the next one in the plane.</content>
public sealed partial class NcInterpreter
{
    private (byte Letter, double Value) _corner;

    private void KeepCorner(MotionKind kind)
    {
        var letter = _words.Corner;
        if (letter == 'M')
        {
            _state.ModalRounding = _words.CornerValue;
        }

        var inPlane = kind is MotionKind.Line or MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
        _corner = !inPlane ? default : letter is (byte)'R' or (byte)'C' or (byte)'F' ? (letter, _words.CornerValue) : _state.ModalRounding > 0 ? ((byte)'R', _state.ModalRounding) : default;
    }

    // Called with the motion that follows, before it is appended: its start moves to the end of the corner.
    private void Corner(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2? center)
    {
        var (letter, value) = _corner;
        var plane = _state.Plane;
        if (letter == 0 || (kind is MotionKind.Line && plane.Project(end) == plane.Project(_state.Position)))
        {
            return;
        }

        var before = _motions[_motions.Length - 1];
        value *= _state.Inch ? MmPerInch : 1;
        var isCut = kind is MotionKind.Line or MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
        var (start, unknownStart) = Work(_state.Position, _state.Unknown);
        var (to, unknownTo) = Work(end, unknownEnd);
        var height = plane.Height(start);
        var behind = new NcMotion(_block, kind, plane, flags, start, to, center ?? default, 0, 0, _state.Frame, unknownStart, unknownTo);
        if (!isCut || !before.MovesInPlane || !behind.MovesInPlane || !(_frame?.OnCircles(plane).StayCircles ?? true) || !(value > 0) || before.Plane != plane || !before.IsKnownInPlane || !behind.IsKnownInPlane || before.Has(MotionFlags.BadArc) || plane.Height(to) != height
            || Between(before, behind, letter, value) is not { } corner)
        {
            Problem("corner-word", "The corner word of the block before cannot be followed here: it needs two cuts in one plane that are long enough for it.", MotionFlags.None);
            Unknow(plane);
            return;
        }

        var block = _block;
        _block = before.Block;
        _motions.MoveLastEnd(plane.Lift(corner.Start, height));
        SetWork(plane.Lift(corner.Start, height), AxisSet.None);
        Append(corner.Kind, MotionFlags.CornerWord, Programmed(plane.Lift(corner.End, height)), AxisSet.None, corner.Center);
        _block = block;
    }

    private Point3 Programmed(Point3 work) => _inverse?.Apply(work) ?? work;

    private void Unknow(CoordinatePlane plane) => _state.Unknown |= plane.Axes();

    private static (MotionKind Kind, Point2 Start, Point2 End, Point2 Center)? Between(in NcMotion before, in NcMotion behind, byte letter, double value)
    {
        var (a, b) = (before.TangentAt(1), behind.TangentAt(0));
        var turn = a.Cross(b);
        if (Math.Abs(turn) < 1e-9)
        {
            return null;
        }

        var vertex = before.PlaneEnd;
        if (letter != 'R')
        {
            // A chamfer by its legs, or by its width.
            var leg = letter == 'C' ? value : value / (2 * Math.Cos(Math.Atan2(Math.Abs(turn), a.Dot(b)) / 2));
            return before.IsArc || behind.IsArc || leg >= before.PlaneLength || leg >= behind.PlaneLength ? null : (MotionKind.Line, vertex - (a * leg), vertex + (b * leg), default);
        }

        // The center lies one radius inside both.
        var left = turn > 0 ? value : -value;
        if (Inside(before, left) is not { } first || Inside(behind, left) is not { } second || first.Meet(second, vertex) is not { } center)
        {
            return null;
        }

        var (from, to) = (FootOf(before, center), FootOf(behind, center));
        var fits = IsOn(before, from) && IsOn(behind, to);
        return fits ? (turn > 0 ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise, from, to, center) : null;
    }

    private static Carrier? Inside(in NcMotion motion, double left)
    {
        if (!motion.IsArc)
        {
            return new(motion.Segment.Line.Offset(left), null);
        }

        var circle = motion.Arc.Circle;
        var radius = circle.Radius - (motion.Kind == MotionKind.ArcCounterClockwise ? left : -left);
        return radius > 0 ? new(null, new(circle.Center, radius)) : null;
    }

    private static Point2 FootOf(in NcMotion motion, Point2 center) => motion.IsArc ? motion.Arc.Circle.Foot(center) : motion.Segment.Line.Foot(center);

    private static bool IsOn(in NcMotion motion, Point2 place) => motion.PlaneAt(motion.IsArc ? motion.Arc.NearestFraction(place) : motion.Segment.NearestFraction(place)).DistanceTo(place) < 1e-6;
}
