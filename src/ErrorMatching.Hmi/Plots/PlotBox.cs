using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A rectangle along the axes of a plot, in plot units.</summary>
/// <param name="Left">Smallest first coordinate.</param>
/// <param name="Low">Smallest second coordinate.</param>
/// <param name="Right">Largest first coordinate.</param>
/// <param name="High">Largest second coordinate.</param>
public readonly record struct PlotBox(double Left, double Low, double Right, double High)
{
    /// <summary>The empty box, which grows as points are added.</summary>
    public static PlotBox Empty => new(double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);

    public bool IsEmpty => !(Left <= Right && Low <= High);

    public Point2 Middle => new((Left + Right) / 2, (Low + High) / 2);

    /// <summary>The bounding box of points; points that are not finite are ignored.</summary>
    public static PlotBox Of(IEnumerable<Point2> points) => points.Aggregate(Empty, (box, p) => box.With(p));

    /// <summary>The box extended by a point, unless the point is not finite.</summary>
    public PlotBox With(Point2 p) =>
        p.IsFinite ? new(Math.Min(Left, p.X), Math.Min(Low, p.Y), Math.Max(Right, p.X), Math.Max(High, p.Y)) : this;

    /// <summary>The box extended by another one.</summary>
    public PlotBox With(PlotBox other) =>
        new(Math.Min(Left, other.Left), Math.Min(Low, other.Low), Math.Max(Right, other.Right), Math.Max(High, other.High));

    /// <summary>True if a point is inside or on the border.</summary>
    public bool Contains(Point2 p) => p.X >= Left && p.X <= Right && p.Y >= Low && p.Y <= High;

    /// <summary>True if the boxes share a point, borders included.</summary>
    public bool Touches(PlotBox other) => Left <= other.Right && other.Left <= Right && Low <= other.High && other.Low <= High;

    /// <summary>True if a polyline crosses it.</summary>
    public bool IsCrossedBy(IReadOnlyList<Point2> line)
    {
        ArgumentNullException.ThrowIfNull(line);
        for (var i = 1; i < line.Count; i++)
        {
            if (PartOf(line[i - 1], line[i]) is not null)
            {
                return true;
            }
        }

        return line.Count == 1 && Contains(line[0]);
    }

    /// <summary>The part of a segment inside it (Y.-D. Liang and B. A. Barsky, ACM Transactions on Graphics 3, 1984, 1); null if
    /// none.</summary>
    public (Point2 From, Point2 To)? PartOf(Point2 a, Point2 b)
    {
        if (Contains(a) && Contains(b))
        {
            return (a, b);
        }

        var (from, to, way) = (0.0, 1.0, b - a);
        return Cut(-way.X, a.X - Left) && Cut(way.X, Right - a.X) && Cut(-way.Y, a.Y - Low) && Cut(way.Y, High - a.Y)
            ? (from > 0 ? a.Lerp(b, from) : a, to < 1 ? a.Lerp(b, to) : b)
            : null;

        bool Cut(double towards, double room)
        {
            if (towards == 0)
            {
                return room >= 0;
            }

            var at = room / towards;
            (from, to) = towards < 0 ? (Math.Max(from, at), to) : (from, Math.Min(to, at));
            return from <= to;
        }
    }
}
