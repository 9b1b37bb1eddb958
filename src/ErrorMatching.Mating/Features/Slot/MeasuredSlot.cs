using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The slot that represents points: two parallel lines, fitted by total least squares with one direction, and round ends tangent
/// to both. Each end is placed by least squares of its points' distances, with half the width as the radius.</summary>
internal sealed record MeasuredSlot
{
    private const int MostSteps = 50;

    /// <summary>Direction of the first flank in the order of cutting: from the second end to the first.</summary>
    public required Vector2 Direction { get; init; }

    /// <summary>Center of the end that is cut after the first flank.</summary>
    public required Point2 FirstCenter { get; init; }

    /// <summary>Center of the end that is cut after the second flank.</summary>
    public required Point2 SecondCenter { get; init; }

    /// <summary>True if the first flank is to the left of the center line, in its direction.</summary>
    public required bool FirstIsLeft { get; init; }

    /// <summary>Half the width, mm.</summary>
    public required double Radius { get; init; }

    /// <summary>First-order standard errors of width, length and direction (radians), and of the middle in x and y, ignoring
    /// correlations.</summary>
    public (double Width, double Length, double Direction, Vector2 Middle) StandardErrors { get; private init; }

    /// <summary>Signed distance of each point from it, positive outside, in the order of the lists, mm.</summary>
    public IReadOnlyList<double> Residuals { get; private init; } = [];

    /// <summary>Width, mm.</summary>
    public double WidthMm => 2 * Radius;

    /// <summary>Length from end to end, mm.</summary>
    public double LengthMm => (FirstCenter - SecondCenter).Dot(Direction) + WidthMm;

    /// <summary>Its middle.</summary>
    public Point2 Middle => FirstCenter.Lerp(SecondCenter, 0.5);

    /// <summary>Fits it.</summary>
    /// <param name="points">Two or more points of the first flank, one or more of the end after it, and likewise of the second flank and
    /// the other end.</param>
    /// <param name="u">Standard uncertainty of a point, mm.</param>
    /// <exception cref="GeometryException">The points determine no slot: flanks with coincident points, or end points beside the
    /// end.</exception>
    public static MeasuredSlot Fit(IReadOnlyList<IReadOnlyList<Point2>> points, double u)
    {
        var (first, second) = (Mean(points[0]), Mean(points[2]));
        var direction = Common(points[0], first, points[2], second);
        direction *= (Mean(points[1]) - Mean(points[3])).Dot(direction) < 0 ? -1 : 1;
        var normal = direction.Left;
        var across = (second - first).Dot(normal);
        var radius = Math.Abs(across) / 2;
        var axis = new Line2(first + (normal * (across / 2)), direction);
        var (one, other) = (End(points[1], axis, radius, 1), End(points[3], axis, radius, -1));
        var slot = new MeasuredSlot
        {
            Direction = direction,
            FirstCenter = axis.At(one.Along),
            SecondCenter = axis.At(other.Along),
            Radius = radius,
            FirstIsLeft = across < 0,
        };
        double[] residuals = [.. points.SelectMany((list, i) => list.Select(p => i % 2 == 0
            ? Math.Abs(axis.SignedDistance(p)) - radius
            : p.DistanceTo(i == 1 ? slot.FirstCenter : slot.SecondCenter) - radius))];

        // Both flanks tilt together. The error of their distance grows with how far apart their points' means are along them.
        var tilt = u / Math.Sqrt(
            points[0].Sum(p => Square((p - first).Dot(direction))) + points[2].Sum(p => Square((p - second).Dot(direction))));
        var width = Math.Sqrt((u * u / points[0].Count) + (u * u / points[2].Count) + Square(tilt * (second - first).Dot(direction)));
        var (oneError, otherError) = (u / Math.Sqrt(one.Share), u / Math.Sqrt(other.Share));
        var (along, aside) = (new Vector2(oneError, otherError).Length / 2, width / 2);
        return slot with
        {
            Residuals = residuals,
            StandardErrors = (
                width,
                new Vector2(new Vector2(oneError, otherError).Length, width).Length,
                tilt,
                new(new Vector2(along * direction.X, aside * normal.X).Length, new Vector2(along * direction.Y, aside * normal.Y).Length)),
        };
    }

    /// <summary>Its boundary as a closed polyline, from the start of the first flank.</summary>
    /// <param name="pieces">Number of pieces of an end.</param>
    public IReadOnlyList<Point2> Outline(int pieces)
    {
        // The side of the first flank; the end arc turns from it to the other flank.
        var side = FirstIsLeft ? Direction.Left : -Direction.Left;
        return
        [
            SecondCenter + (side * Radius),
            .. Enumerable.Range(0, pieces + 1).Select(i => FirstCenter + (Turned(i) * Radius)),
            .. Enumerable.Range(0, pieces + 1).Select(i => SecondCenter - (Turned(i) * Radius)),
        ];

        Vector2 Turned(int i)
        {
            var angle = Math.PI * i / pieces;
            return (side * Elementary.Cos(angle)) + (Direction * Elementary.Sin(angle));
        }
    }

    private static double Square(double value) => value * value;

    private static Point2 Mean(IReadOnlyList<Point2> points) =>
        Point2.Origin + (points.Aggregate(Vector2.Zero, (sum, p) => sum + (p - Point2.Origin)) / points.Count);

    // The direction of largest scatter of both flanks' points about their own means (total least squares).
    private static Vector2 Common(IReadOnlyList<Point2> a, Point2 meanOfA, IReadOnlyList<Point2> b, Point2 meanOfB)
    {
        var (xx, xy, yy) = (0.0, 0.0, 0.0);
        foreach (var d in a.Select(p => p - meanOfA).Concat(b.Select(p => p - meanOfB)))
        {
            (xx, xy, yy) = (xx + (d.X * d.X), xy + (d.X * d.Y), yy + (d.Y * d.Y));
        }

        return xx + yy > Square(Intersect.DefaultTolerance)
            ? Vector2.FromDirection(Angle.FromRadians(Elementary.Atan2(2 * xy, xx - yy) / 2))
            : throw new GeometryException(GeometryError.CoincidentPoints, "The points of each flank lie on one place.");
    }

    // Position of an end's center along the axis, and the sum of squared slopes with which its points determine it.
    private static (double Along, double Share) End(IReadOnlyList<Point2> points, Line2 axis, double radius, int outward)
    {
        var beside = points.Max(p => Math.Abs(axis.SignedDistance(p)));
        if (beside >= radius)
        {
            throw new GeometryException(
                GeometryError.NotAround,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"A point of an end lies {beside:0.###} mm beside the center line, no less than half the width of {2 * radius:0.###} "
                        + $"mm."));
        }

        var along = points.Average(p => axis.Along(p) - (outward * Math.Sqrt(Square(radius) - Square(axis.SignedDistance(p)))));
        for (var step = 0; step < MostSteps; step++)
        {
            var (sum, share) = (0.0, 0.0);
            foreach (var point in points)
            {
                var spoke = point - axis.At(along);
                var slope = spoke.Dot(axis.Direction) / spoke.Length;
                (sum, share) = (sum + (slope * (spoke.Length - radius)), share + Square(slope));
            }

            along += sum / share;
            if (Math.Abs(sum / share) <= 1e-13 * (radius + Math.Abs(along)))
            {
                return (along, share);
            }
        }

        throw new GeometryException(GeometryError.NotConverged, "The end of the slot did not settle.");
    }
}
