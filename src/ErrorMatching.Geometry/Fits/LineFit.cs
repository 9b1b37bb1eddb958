namespace ErrorMatching.Geometry;

/// <summary>A straight line through measured points by least squares, with what the points leave unexplained. Immutable.</summary>
/// <remarks>
/// Standard errors take as the standard deviation of a point the larger of what the residuals show (<c>n - 2</c> degrees of freedom) and the uncertainty
/// stated by the caller: few points may agree by chance, but they are not better than the gauge. With two points there are no residuals and only the stated one counts.
/// </remarks>
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

    /// <summary>The fitted line. Its origin is the centroid of the points; it runs from the first point toward the last, or toward +x (+y if vertical) where these two project on one place.</summary>
    public Line2 Line { get; }

    /// <summary>The centroid of the points, which lies on the line.</summary>
    public Point2 Centroid => Line.Origin;

    /// <summary>The piece of the line between its two extreme projected points, in the direction of the line.</summary>
    public Segment2 Extent { get; }

    /// <summary>Distance between the extreme projected points, in millimetres.</summary>
    public double Length => Extent.Length;

    /// <summary>
    /// One residual per point, in the order given, in millimetres: signed distance to the left of the line for a total fit, measured y less fitted y for an ordinary one.
    /// </summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Root of the sum of squared residuals over <c>n - 2</c>, in millimetres; zero for two points.</summary>
    public double ResidualStandardDeviation { get; }

    /// <summary>Standard error of the line's position across itself at the centroid, in millimetres.</summary>
    public double OffsetStandardError { get; private init; }

    /// <summary>Standard error of the line's direction (to first order).</summary>
    public Angle AngleStandardError { get; private init; }

    /// <summary>
    /// How well the points determine the line, 1 at best. Total: <c>(a + b) / (a - b)</c> of the squared spreads along and across, large where the points have
    /// no preferred direction. Ordinary: the 2-norm condition number of the design with the columns 1 and x.
    /// </summary>
    public double Condition { get; private init; }

    /// <summary>The line as an equation of y in x; only an ordinary fit has one.</summary>
    public LineEquation? Equation { get; private init; }

    /// <summary>Standard error of the line's position across itself at a place of the plane (its foot on the line counts), in millimetres.</summary>
    public double OffsetStandardErrorAt(Point2 place) => Math.Sqrt(Square(OffsetStandardError) + Square(Line.Along(place) * AngleStandardError.Radians));

    private static double Square(double value) => value * value;

    private static Vector2 Orient(Vector2 direction, IReadOnlyList<Point2> points)
    {
        var ahead = (points[^1] - points[0]).Dot(direction);
        var backward = ahead != 0 ? ahead < 0 : direction.X != 0 ? direction.X < 0 : direction.Y < 0;
        return backward ? -direction : direction;
    }
}
