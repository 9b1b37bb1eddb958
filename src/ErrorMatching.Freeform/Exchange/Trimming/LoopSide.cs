using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A straight piece of a loop's side, short enough to lie on the surface in space as well.</summary>
/// <param name="Loop">Index of its loop.</param>
/// <param name="Index">Index of the side of the loop's polygon that it is a piece of.</param>
/// <param name="From">Parameters where it begins.</param>
/// <param name="To">Parameters where it ends.</param>
/// <param name="Start">Where it begins, in millimetres.</param>
/// <param name="End">Where it ends.</param>
/// <param name="AtMm">Length of the loop before it.</param>
internal readonly record struct LoopSide(int Loop, int Index, Point2 From, Point2 To, Point3 Start, Point3 End, double AtMm)
{
    /// <summary>Its length.</summary>
    public double LengthMm => (End - Start).Length;

    /// <summary>The smallest box around it.</summary>
    public Box3 Box => Box3.Around([Start, End]);

    /// <summary>The point at a share of its length.</summary>
    public Point3 At(double share) => Start + ((End - Start) * share);

    /// <summary>The shares of its length between which it is within a distance of a line from one point to another; null if it is nowhere.</summary>
    /// <remarks>The places within a distance of a line are a cylinder with a ball at either end, which is convex: a straight line is in it from one share to another.</remarks>
    public (double From, double To)? Near(Point3 from, Point3 to, double distanceMm)
    {
        var (least, most) = (double.PositiveInfinity, double.NegativeInfinity);
        var (along, other, apart) = (End - Start, to - from, Start - from);
        Add(Ball(along, apart, distanceMm));
        Add(Ball(along, Start - to, distanceMm));
        var length = other.Dot(other);
        if (length > 0)
        {
            // What is left of both beside the line decides on the distance, what lies along it on the ends.
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
