using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A straight piece of a loop's side, short enough to follow the surface in space too.</summary>
/// <param name="Loop">Index of its loop.</param>
/// <param name="Index">Index of the side of the loop's polygon.</param>
/// <param name="From">Parameters of its start.</param>
/// <param name="To">Parameters of its end.</param>
/// <param name="Start">Its start, in millimeters.</param>
/// <param name="End">Its end.</param>
/// <param name="AtMm">Length of the loop up to its start.</param>
internal readonly record struct LoopSide(int Loop, int Index, Point2 From, Point2 To, Point3 Start, Point3 End, double AtMm)
{
    public double LengthMm => (End - Start).Length;

    public Box3 Box => Box3.Around([Start, End]);

    public Point3 At(double share) => Start + ((End - Start) * share);

    /// <summary>Returns the shares of its length between which it is within a distance of a line segment; null if nowhere.</summary>
    /// <remarks>The places within a distance of a segment form a cylinder with a ball at each end. This is convex, so a straight line is
    /// inside it from one share to another.</remarks>
    public (double From, double To)? Near(Point3 from, Point3 to, double distanceMm)
    {
        var (least, most) = (double.PositiveInfinity, double.NegativeInfinity);
        var (along, other, apart) = (End - Start, to - from, Start - from);
        Add(Ball(along, apart, distanceMm));
        Add(Ball(along, Start - to, distanceMm));
        var length = other.Dot(other);
        if (length > 0)
        {
            // The components across the segment decide the distance; the components along it decide the ends.
            var (share, slope) = (apart.Dot(other) / length, along.Dot(other) / length);
            if (Ball(along - (other * slope), apart - (other * share), distanceMm) is { } beside && Within(share, slope) is { } between)
            {
                Add((Math.Max(beside.From, between.From), Math.Min(beside.To, between.To)));
            }
        }

        (least, most) = (Math.Max(0, least), Math.Min(1, most));
        return least <= most ? (least, most) : null;

        void Add((double From, double To)? part)
        {
            if (part is { } p && p.From <= p.To)
            {
                (least, most) = (Math.Min(least, p.From), Math.Max(most, p.To));
            }
        }
    }

    // Where |apart + t along| <= radius.
    private static (double From, double To)? Ball(Vector3 along, Vector3 apart, double radius)
    {
        var (a, b, c) = (along.Dot(along), along.Dot(apart), apart.Dot(apart) - (radius * radius));
        if (a == 0)
        {
            return c <= 0 ? (double.NegativeInfinity, double.PositiveInfinity) : null;
        }

        var root = (b * b) - (a * c);
        return root < 0 ? null : ((-b - Math.Sqrt(root)) / a, (-b + Math.Sqrt(root)) / a);
    }

    // Where 0 <= share + t slope <= 1.
    private static (double From, double To)? Within(double share, double slope) => slope switch
    {
        > 0 => (-share / slope, (1 - share) / slope),
        < 0 => ((1 - share) / slope, -share / slope),
        _ => share is >= 0 and <= 1 ? (double.NegativeInfinity, double.PositiveInfinity) : null,
    };
}
