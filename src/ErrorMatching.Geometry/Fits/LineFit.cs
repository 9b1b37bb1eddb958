namespace ErrorMatching.Geometry;

/// <summary>A straight line fitted to measured points by least squares, with its residuals. Immutable.</summary>
/// <remarks>The standard errors are based on the standard deviation of a point: that of the residuals (<c>n - 2</c> degrees of freedom) or
/// the caller's uncertainty, whichever is larger. A few points may agree by chance, but they are not better than the gauge. Two points
/// have no residuals, so only the stated uncertainty counts.</remarks>
public sealed class LineFit
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

    // Total least squares.

    /// <summary>The line with the least sum of squared perpendicular distances: through the centroid, along the principal axis.</summary>
    /// <remarks>The axis is the eigenvector of the larger eigenvalue of the scatter matrix of the centered points. Twice its angle to x is
    /// the direction of <c>(Sxx - Syy, 2 Sxy)</c>. It is exact to rounding, however thin the cloud is.</remarks>
    /// <param name="points">At least two points.</param>
    /// <param name="pointUncertaintyMm">The gauge's standard uncertainty of a point across the line, in millimeters; 0 if unknown.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>;
    /// <see cref="GeometryError.CoincidentPoints"/> if all points are within 1e-9 mm; <see cref="GeometryError.RankDeficient"/> if the
    /// points spread equally in all directions.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static LineFit Total(IReadOnlyList<Point2> points, double pointUncertaintyMm = 0)
    {
        Samples.Check(points, 2, "A line");
        Samples.CheckUncertainty(pointUncertaintyMm);
        var centroid = Samples.Centroid(points);
        var (sxx, sxy, syy) = (0.0, 0.0, 0.0);
        foreach (var point in points)
        {
            var (x, y) = (point.X - centroid.X, point.Y - centroid.Y);
            (sxx, sxy, syy) = (sxx + (x * x), sxy + (x * y), syy + (y * y));
        }

        RefuseCoincident(points, centroid);
        var difference = Math.Sqrt(Square(sxx - syy) + (4 * sxy * sxy));
        if (difference <= 1e-12 * (sxx + syy))
        {
            throw new GeometryException(
                GeometryError.RankDeficient, "The points of the line spread alike in all directions: they have no direction.");
        }

        // The eigenvector, from the row without cancellation.
        var axis = sxx >= syy ? new Vector2(sxx - syy + difference, 2 * sxy) : new Vector2(2 * sxy, syy - sxx + difference);
        var line = new Line2(centroid, Orient(axis, points));
        var residuals = new double[points.Count];
        var spread = 0.0;
        for (var i = 0; i < points.Count; i++)
        {
            residuals[i] = line.SignedDistance(points[i]);
            spread += Square(line.Along(points[i]));
        }

        var sigma = Math.Max(Samples.StandardDeviation(residuals, 2), pointUncertaintyMm);
        return new(line, points, residuals)
        {
            OffsetStandardError = sigma / Math.Sqrt(points.Count),
            AngleStandardError = Angle.FromRadians(sigma / Math.Sqrt(spread)),
            Condition = (sxx + syy) / difference,
        };
    }

    private static void RefuseCoincident(IReadOnlyList<Point2> points, Point2 centroid)
    {
        foreach (var point in points)
        {
            if (point.DistanceTo(centroid) > Intersect.DefaultTolerance)
            {
                return;
            }
        }

        throw new GeometryException(GeometryError.CoincidentPoints, $"All {points.Count} points of the line lie on one another.");
    }

    // Ordinary least squares.

    /// <summary>The line with the least sum of squared distances in y (equation 4 of Wang 2021). It is calculated about the centroid, so a
    /// distance from the origin costs no digits.</summary>
    /// <param name="points">At least two points with different x.</param>
    /// <param name="pointUncertaintyMm">The gauge's standard uncertainty of a point's y, in millimeters; zero if unknown.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>;
    /// <see cref="GeometryError.CoincidentPoints"/> if all points are within 1e-9 mm; <see cref="GeometryError.RankDeficient"/> if all x
    /// agree to 1e-12 of the largest, so that y is not a function of x.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static LineFit Ordinary(IReadOnlyList<Point2> points, double pointUncertaintyMm = 0)
    {
        Samples.Check(points, 2, "A line");
        Samples.CheckUncertainty(pointUncertaintyMm);
        var centroid = Samples.Centroid(points);
        RefuseCoincident(points, centroid);
        var (sxx, sxy, largest, spreadX) = (0.0, 0.0, 0.0, 0.0);
        foreach (var point in points)
        {
            var (x, y) = (point.X - centroid.X, point.Y - centroid.Y);
            (sxx, sxy) = (sxx + (x * x), sxy + (x * y));
            (largest, spreadX) = (Math.Max(largest, Math.Abs(point.X)), Math.Max(spreadX, Math.Abs(x)));
        }

        if (spreadX <= 1e-12 * largest)
        {
            throw new GeometryException(
                GeometryError.RankDeficient,
                "All points of the line have the same x, so y is no function of x. Fit it by total least squares.");
        }

        var n = points.Count;
        var slope = sxy / sxx;
        var residuals = new double[n];
        for (var i = 0; i < n; i++)
        {
            residuals[i] = points[i].Y - centroid.Y - (slope * (points[i].X - centroid.X));
        }

        var sigma = Math.Max(Samples.StandardDeviation(residuals, 2), pointUncertaintyMm);
        var slopeError = sigma / Math.Sqrt(sxx);
        var cosine = 1 / Math.Sqrt(1 + (slope * slope));
        var trace = n + sxx + (n * Square(centroid.X));
        var determinant = n * sxx;
        return new(new Line2(centroid, Orient(new(1, slope), points)), points, residuals)
        {
            OffsetStandardError = sigma * cosine / Math.Sqrt(n),
            AngleStandardError = Angle.FromRadians(slopeError * cosine * cosine),
            Condition = (trace + Math.Sqrt(Math.Max(0, (trace * trace) - (4 * determinant)))) / (2 * Math.Sqrt(determinant)),
            Equation = new(centroid.Y - (slope * centroid.X), sigma * Math.Sqrt((1.0 / n) + (Square(centroid.X) / sxx)), slope, slopeError),
        };
    }
}

/// <summary>The straight line <c>y = Intercept + Slope x</c> (equation 4 of Wang 2021) with standard errors.</summary>
/// <param name="Intercept">y at x = 0, in millimeters.</param>
/// <param name="InterceptStandardError">Standard error of the intercept, in millimeters.</param>
/// <param name="Slope">Rise of y per x.</param>
/// <param name="SlopeStandardError">Standard error of the slope.</param>
public readonly record struct LineEquation(double Intercept, double InterceptStandardError, double Slope, double SlopeStandardError);
