namespace ErrorMatching.Geometry;

/// <content>Ordinary least squares.</content>
public sealed partial class LineFit
{
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
