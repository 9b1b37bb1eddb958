namespace ErrorMatching.Geometry;

/// <content>Total least squares.</content>
public sealed partial class LineFit
{
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
}
