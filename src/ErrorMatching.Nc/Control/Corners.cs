using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Handles corner words: a rounding or chamfer between the motion that has the word and the next one in the plane.</summary>
internal sealed class Corners(NcControl control)
{
    private (byte Letter, double Value) _pending;

    /// <summary>True if a corner is pending until the next motion.</summary>
    public bool IsPending => _pending.Letter != 0;

    /// <summary>Stores the block's corner for the end of its motion.</summary>
    public void Keep(MotionKind kind)
    {
        var letter = control.Words.Corner;
        var inPlane = kind is MotionKind.Line or MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
        _pending = !inPlane
            ? default
            : letter is (byte)'R' or (byte)'C' or (byte)'F'
            ? (letter, control.Values.CornerLength())
            : control.State.ModalRounding != 0
            ? ((byte)'R', control.State.ModalRounding)
            : default;
    }

    /// <summary>Stores the corner that a block of its own states for the end of the motion before it.</summary>
    public void KeepForLast(NcMeaning meaning)
    {
        var last = control.Result.Motions.Length - 1;
        var isRounding = meaning == NcMeaning.CornerRounding;
        var value = isRounding ? control.Words.Has('R') ? control.Words.Value('R') : double.NaN : control.Values.CornerLength();
        _pending = last >= 0 && control.Result.Motions[last].IsCut ? (isRounding ? (byte)'R' : (byte)'C', value) : default;
        if (!IsPending)
        {
            control.Result.Problem("corner-word", "No cut is before this corner: it cannot be followed.", MotionFlags.None);
            control.State.Unknown |= control.State.Plane.Axes();
        }
    }

    /// <summary>Inserts the corner. Call it with the next motion before that is appended: its start moves to the end of the corner. The
    /// center is in work coordinates.</summary>
    public void Cut(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2? center)
    {
        var (letter, value) = _pending;
        var plane = control.State.Plane;
        if (letter == 0)
        {
            return;
        }

        if (control.Dialect.Ways.DropsCornerOffPlane
            && kind is MotionKind.Line or MotionKind.Rapid
            && plane.Project(end) == plane.Project(control.State.Position))
        {
            _pending = default;
            return;
        }

        var before = control.Result.Motions[control.Result.Motions.Length - 1];
        var behind = new NcMotion(
            control.Result.Block,
            kind,
            plane,
            flags,
            control.Layers.Work(control.State.Position, AxisSet.None).Place,
            control.Layers.Work(end, AxisSet.None).Place,
            center ?? default,
            0,
            0,
            control.State.Frame,
            control.State.Unknown,
            unknownEnd);
        var isPlain = behind is { IsCut: true, MovesInPlane: true, IsKnownInPlane: true }
            && before is { MovesInPlane: true, IsKnownInPlane: true }
            && !before.Has(MotionFlags.BadArc)
            && !flags.HasFlag(MotionFlags.BadArc);
        var isLevel = before.Plane == plane
            && before.Frame == behind.Frame
            && plane.Height(behind.End) == plane.Height(behind.Start)
            && (control.Layers.Transforms.Frame?.OnCircles(plane).StayCircles ?? true);
        value *= control.Unit * (control.Layers.Transforms.Frame?.FactorIn(plane) ?? 1);
        if (!isPlain || !isLevel || !(value > 0) || Between(before, behind, letter, value) is not { } corner)
        {
            Lose();
            return;
        }

        var (block, height) = (control.Result.Block, plane.Height(behind.Start));
        control.Result.Block = before.Block;
        control.Result.Motions.MoveLastEnd(plane.Lift(corner.Start, height));
        control.State.Position = control.Layers.Programmed(plane.Lift(corner.Start, height));
        control.Moves.Append(corner.Kind, MotionFlags.CornerWord, control.Layers.Programmed(plane.Lift(corner.End, height)), AxisSet.None,
            corner.Center);
        control.Result.Block = block;
    }

    /// <summary>Drops the corner without a problem: the tool leaves the plane first.</summary>
    public void Drop() => _pending = default;

    /// <summary>Reports a corner that cannot be followed: where the tool leaves the previous element is unknown.</summary>
    public void Lose()
    {
        if (IsPending)
        {
            control.Result.Problem(
                "corner-word",
                "The corner word of the block before cannot be followed here: it needs two cuts in one plane that are long enough for it.",
                MotionFlags.None);
            control.State.Unknown |= control.State.Plane.Axes();
            _pending = default;
        }
    }

    private static (MotionKind Kind, Point2 Start, Point2 End, Point2 Center)? Between(
        in NcMotion before, in NcMotion behind, byte letter, double value)
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
            // A chamfer by its leg length or by its width.
            var leg = letter == 'C' ? value : value / (2 * Elementary.Cos(Elementary.Atan2(Math.Abs(turn), a.Dot(b)) / 2));
            return before.IsArc || behind.IsArc || leg >= before.PlaneLength || leg >= behind.PlaneLength
                ? null
                : (MotionKind.Line, vertex - (a * leg), vertex + (b * leg), default);
        }

        // The center is one radius inside both.
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

    private static Point2 FootOf(in NcMotion motion, Point2 center) =>
        motion.IsArc ? motion.Arc.Circle.Foot(center) : motion.Segment.Line.Foot(center);

    private static bool IsOn(in NcMotion motion, Point2 place) =>
        motion.PlaneAt(motion.IsArc ? motion.Arc.NearestFraction(place) : motion.Segment.NearestFraction(place)).DistanceTo(place) < 1e-6;
}
