using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Corner words: a rounding or a chamfer between the motion that has the word and the next one in the plane.</content>
public sealed partial class NcInterpreter
{
    private (byte Letter, double Value) _corner;

    private void KeepCorner(MotionKind kind)
    {
        var letter = _words.Corner;
        var inPlane = kind is MotionKind.Line or MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
        _corner = !inPlane ? default : letter is (byte)'R' or (byte)'C' or (byte)'F' ? (letter, CornerLength()) : _state.ModalRounding != 0 ? ((byte)'R', _state.ModalRounding) : default;
    }

    private double CornerLength() => _words.CornerValue / (_dialect.IntegersAreIncrements && _words.CornerIsInteger ? Math.Pow(10, LeastDecimals) : 1);

    // Called with the motion that follows, before it is appended: its start moves to the end of the corner. All places are those of the work, the center too.
    private void Corner(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2? center)
    {
        var (letter, value) = _corner;
        var plane = _state.Plane;
        if (letter == 0)
        {
            return;
        }

        if (_dialect.Syntax == NcSyntax.Siemens && kind is MotionKind.Line or MotionKind.Rapid && plane.Project(end) == plane.Project(_state.Position))
        {
            // Siemens inserts nothing where the next motion leaves the plane.
            _corner = default;
            return;
        }

        var before = _motions[_motions.Length - 1];
        var behind = new NcMotion(_block, kind, plane, flags, Work(_state.Position, AxisSet.None).Place, Work(end, AxisSet.None).Place, center ?? default, 0, 0, _state.Frame, _state.Unknown, unknownEnd);
        var isPlain = behind is { IsCut: true, MovesInPlane: true, IsKnownInPlane: true } && before is { MovesInPlane: true, IsKnownInPlane: true } && !before.Has(MotionFlags.BadArc) && !flags.HasFlag(MotionFlags.BadArc);
        var isLevel = before.Plane == plane && before.Frame == behind.Frame && plane.Height(behind.End) == plane.Height(behind.Start) && (_frame?.OnCircles(plane).StayCircles ?? true);
        value *= (_state.Inch ? MmPerInch : 1) * (_frame?.FactorIn(plane) ?? 1);
        if (!isPlain || !isLevel || !(value > 0) || Between(before, behind, letter, value) is not { } corner)
        {
            LoseCorner();
            return;
        }

        var (block, height) = (_block, plane.Height(behind.Start));
        _block = before.Block;
        _motions.MoveLastEnd(plane.Lift(corner.Start, height));
        _state.Position = Programmed(plane.Lift(corner.Start, height));
        Append(corner.Kind, MotionFlags.CornerWord, Programmed(plane.Lift(corner.End, height)), AxisSet.None, corner.Center);
        _block = block;
    }

    // A corner that is asked for and cannot be followed: where the tool leaves the element before is not known.
    private void LoseCorner()
    {
        if (_corner.Letter != 0)
        {
            Problem("corner-word", "The corner word of the block before cannot be followed here: it needs two cuts in one plane that are long enough for it.", MotionFlags.None);
            _state.Unknown |= _state.Plane.Axes();
            _corner = default;
        }
    }

    private Point3 Programmed(Point3 work) => _inverse?.Apply(work) ?? work;

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
