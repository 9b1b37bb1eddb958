using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>What every fit asks of its points before it starts, and the statistics every fit ends with.</summary>
internal static class Samples
{
    /// <summary>Refuses too few points and coordinates that are no numbers.</summary>
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
                    string.Create(CultureInfo.InvariantCulture, $"Point {i + 1} of {points.Count} has a coordinate that is not a finite number."));
            }
        }
    }

    /// <summary>Refuses a stated uncertainty that is negative or no number.</summary>
    public static void CheckUncertainty(double pointUncertaintyMm)
    {
        if (!(pointUncertaintyMm >= 0) || !double.IsFinite(pointUncertaintyMm))
        {
            throw new ArgumentOutOfRangeException(nameof(pointUncertaintyMm), pointUncertaintyMm, "A standard uncertainty is zero or more.");
        }
    }

    /// <summary>The mean of the points.</summary>
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

    /// <summary>Residual standard deviation with a number of unknowns taken off the points; zero where none are left over.</summary>
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
