using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>Input checks and statistics shared by all fits.</summary>
internal static class Samples
{
    /// <summary>Throws if there are too few points or a coordinate is not finite.</summary>
    public static void Check(IReadOnlyList<Point2> points, int least, string element)
    {
        if (points.Count < least)
        {
            throw new GeometryException(
                GeometryError.TooFewPoints,
                string.Create(CultureInfo.InvariantCulture, $"{element} needs at least {least} points; {points.Count} given."));
        }

        for (var i = 0; i < points.Count; i++)
        {
            if (!points[i].IsFinite)
            {
                throw new GeometryException(
                    GeometryError.NotFinite,
                    string.Create(
                        CultureInfo.InvariantCulture, $"Point {i + 1} of {points.Count} has a coordinate that is not a finite number."));
            }
        }
    }

    /// <summary>Throws if a stated uncertainty is negative or not finite.</summary>
    public static void CheckUncertainty(double pointUncertaintyMm)
    {
        if (!(pointUncertaintyMm >= 0) || !double.IsFinite(pointUncertaintyMm))
        {
            throw new ArgumentOutOfRangeException(
                nameof(pointUncertaintyMm), pointUncertaintyMm, "A standard uncertainty is zero or more.");
        }
    }

    public static Point2 Centroid(IReadOnlyList<Point2> points)
    {
        var origin = points[0];
        var sum = Vector2.Zero;
        foreach (var point in points)
        {
            sum += point - origin;
        }

        return origin + (sum / points.Count);
    }

    /// <summary>Residual standard deviation, with the unknowns subtracted from the number of points; zero if none remain.</summary>
    public static double StandardDeviation(IReadOnlyList<double> residuals, int unknowns)
    {
        var sum = 0.0;
        foreach (var residual in residuals)
        {
            sum += residual * residual;
        }

        return residuals.Count > unknowns ? Math.Sqrt(sum / (residuals.Count - unknowns)) : 0;
    }
}
