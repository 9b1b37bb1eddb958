namespace ErrorMatching.Geometry;

/// <summary>A straight line fitted to measured points by least squares, with its residuals. Immutable.</summary>
/// <remarks>The standard errors are based on the standard deviation of a point: that of the residuals (<c>n - 2</c> degrees of freedom) or
/// the caller's uncertainty, whichever is larger. A few points may agree by chance, but they are not better than the gauge. Two points
/// have no residuals, so only the stated uncertainty counts.</remarks>
public sealed partial class LineFit
{
    private LineFit(Line2 line, IReadOnlyList<Point2> points, double[] residuals)
    {
        Line = line;
        Residuals = Array.AsReadOnly(residuals);
        ResidualStandardDeviation = Samples.StandardDeviation(residuals, 2);
        var (from, to) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (var point in points)
        {
            var along = line.Along(point);
            (from, to) = (Math.Min(from, along), Math.Max(to, along));
        }

        Extent = new(line.At(from), line.At(to));
    }

    /// <summary>The fitted line. Its origin is the centroid of the points. It runs from the first point towards the last, or towards +x
    /// (+y if vertical) if their projections coincide.</summary>
    public Line2 Line { get; }

    /// <summary>The centroid of the points, which is on the line.</summary>
    public Point2 Centroid => Line.Origin;

    /// <summary>The part of the line between the extreme projected points, in the direction of the line.</summary>
    public Segment2 Extent { get; }

    /// <summary>Distance between the extreme projected points, in millimeters.</summary>
    public double Length => Extent.Length;

    /// <summary>One residual per point, in the given order, in millimeters: signed distance to the left of the line for a total fit,
    /// measured minus fitted y for an ordinary one.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Root of the sum of squared residuals divided by <c>n - 2</c>, in millimeters; zero for two points.</summary>
    public double ResidualStandardDeviation { get; }

    /// <summary>Standard error of the line's perpendicular position at the centroid, in millimeters.</summary>
    public double OffsetStandardError { get; private init; }

    /// <summary>Standard error of the line's direction, to first order.</summary>
    public Angle AngleStandardError { get; private init; }

    /// <summary>How well the points determine the line, 1 at best. Total: <c>(a + b) / (a - b)</c> of the squared spreads along and
    /// across, large if the points have no preferred direction. Ordinary: the 2-norm condition number of the design matrix with the
    /// columns 1 and x.</summary>
    public double Condition { get; private init; }

    /// <summary>The line as an equation of y in x; null for a total fit.</summary>
    public LineEquation? Equation { get; private init; }

    /// <summary>Standard error of the line's perpendicular position at the foot of a point, in millimeters.</summary>
    public double OffsetStandardErrorAt(Point2 place) =>
        Math.Sqrt(Square(OffsetStandardError) + Square(Line.Along(place) * AngleStandardError.Radians));

    private static double Square(double value) => value * value;

    private static Vector2 Orient(Vector2 direction, IReadOnlyList<Point2> points)
    {
        var ahead = (points[^1] - points[0]).Dot(direction);
        var backward = ahead != 0 ? ahead < 0 : direction.X != 0 ? direction.X < 0 : direction.Y < 0;
        return backward ? -direction : direction;
    }
}
