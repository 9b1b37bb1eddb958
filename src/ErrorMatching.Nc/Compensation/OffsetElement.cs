using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A programmed line or arc, and the path of the tool's center beside it.</summary>
/// <param name="Motion">Position of the programmed motion.</param>
/// <param name="IsArc">True for an arc.</param>
/// <param name="IsCounterClockwise">Direction of an arc.</param>
/// <param name="StartTangent">Unit direction of travel at the start.</param>
/// <param name="EndTangent">Unit direction of travel at the end.</param>
/// <param name="Start">The tool's center beside its start.</param>
/// <param name="ProgrammedEnd">Its programmed end.</param>
/// <param name="End">The tool's center beside its end.</param>
/// <param name="Center">Center of an arc.</param>
/// <param name="StartRadius">Radius of the tool's center about it at the start, mm; not positive if the tool does not fit.</param>
/// <param name="Radius">The same at the end: the two radii of an arc differ by the rounding of its words.</param>
internal readonly record struct OffsetElement(
    int Motion,
    bool IsArc,
    bool IsCounterClockwise,
    Vector2 StartTangent,
    Vector2 EndTangent,
    Point2 Start,
    Point2 ProgrammedEnd,
    Point2 End,
    Point2 Center,
    double StartRadius,
    double Radius)
{
    /// <summary>Places on a circle closer than this are the same, mm.</summary>
    private const double SamePlace = 1e-7;

    /// <summary>An element of the programmed contour.</summary>
    /// <param name="motion">The programmed motion, which moves in its plane.</param>
    /// <param name="index">Its position.</param>
    /// <param name="left">Distance of the tool's center to the left of travel, mm.</param>
    public static OffsetElement Of(in NcMotion motion, int index, double left)
    {
        var (start, end) = (motion.PlaneStart, motion.PlaneEnd);
        if (!motion.IsArc)
        {
            return Straight(start, end, index, left);
        }

        var turns = motion.Kind == MotionKind.ArcCounterClockwise;
        var (atStart, atEnd) = ((start - motion.Center).Normalize(), (end - motion.Center).Normalize());
        var outwards = turns ? -left : left;
        return new(
            index,
            true,
            turns,
            turns ? atStart.Left : -atStart.Left,
            turns ? atEnd.Left : -atEnd.Left,
            start + (atStart * outwards),
            end,
            end + (atEnd * outwards),
            motion.Center,
            motion.Center.DistanceTo(start) + outwards,
            motion.Center.DistanceTo(end) + outwards);
    }

    /// <summary>A straight element.</summary>
    /// <param name="start">Its start.</param>
    /// <param name="end">Its end.</param>
    /// <param name="index">Position of the programmed motion.</param>
    /// <param name="left">Distance of the tool's center to the left of travel, mm.</param>
    public static OffsetElement Straight(Point2 start, Point2 end, int index, double left)
    {
        var along = (end - start).Normalize();
        return new(index, false, false, along, along, start + (along.Left * left), end, end + (along.Left * left), default, 0, 0);
    }

    /// <summary>Where the paths of the tool's center beside two elements meet; null if they do not. Of two places it is the first one that
    /// is reached by going back from the corner on this element and on from it on the next; if neither is, the nearest one.</summary>
    /// <param name="next">The element after it.</param>
    public Point2? Meet(in OffsetElement next)
    {
        var places = (IsArc, next.IsArc) switch
        {
            (false, false) => Intersect.Lines(LineAtEnd, next.LineAtEnd),
            (false, true) => Intersect.LineCircle(LineAtEnd, next.CircleAtStart),
            (true, false) => Intersect.LineCircle(next.LineAtEnd, CircleAtEnd),
            _ => Intersect.Circles(CircleAtEnd, next.CircleAtEnd),
        };
        if (places.Count < 2)
        {
            return places.Nearest(ProgrammedEnd);
        }

        var isFirst = IsBefore(places.First) && next.IsAfter(places.First);
        var isSecond = IsBefore(places.Second) && next.IsAfter(places.Second);
        return isFirst == isSecond ? places.Nearest(ProgrammedEnd) : isFirst ? places.First : places.Second;
    }

    /// <summary>The angle from one place on its circle to another in its direction, radians, above 0 and up to a full turn.</summary>
    public double Sweep(Point2 from, Point2 to)
    {
        var sweep = Turned(from, to);
        return sweep * Radius <= SamePlace ? sweep + (2 * Math.PI) : sweep;
    }

    /// <summary>How much of the element the tool's center travels between two places near its ends: mm of a line, radians of an arc;
    /// negative if it would have to go backwards.</summary>
    public double Remaining(Point2 from, Point2 to) =>
        IsArc ? Sweep(Start, End) - Turned(Start, from) - Turned(to, End) : (to - from).Dot(EndTangent);

    // The angle from one place to another in its direction, radians, in (-pi, pi].
    private double Turned(Point2 from, Point2 to)
    {
        var (a, b) = (from - Center, to - Center);
        var angle = Elementary.Atan2(a.Cross(b), a.Dot(b));
        return IsCounterClockwise ? angle : -angle;
    }

    // Whether a place is reached by going back from the end, or on from the start: on an arc, by less than half a turn.
    private bool IsBefore(Point2 place) => IsArc ? Sweep(place, End) < Math.PI : (place - End).Dot(EndTangent) <= SamePlace;

    private bool IsAfter(Point2 place) => IsArc ? Sweep(Start, place) < Math.PI : (place - Start).Dot(StartTangent) >= -SamePlace;

    private Line2 LineAtEnd => new(End, EndTangent);

    private Circle2 CircleAtStart => new(Center, Math.Max(StartRadius, 0));

    private Circle2 CircleAtEnd => new(Center, Math.Max(Radius, 0));
}
