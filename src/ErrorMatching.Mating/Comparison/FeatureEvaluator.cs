using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;
using MathNet.Numerics.Integration;

namespace ErrorMatching.Mating;

/// <summary>Evaluates features as designed and as measured (Wang 2021, sections 2.1 to 2.4).</summary>
internal static class FeatureEvaluator
{
    /// <summary>One key point is recommended for so many millimetres of a curve (Wang 2021, section 2.1).</summary>
    public const double RecommendedSpacingMm = 5;

    // 64 nodes integrate the arc length of a polynomial of degree 10 to nanometres while its slope stays below 10.
    private const int QuadratureOrder = 64;

    /// <summary>Evaluates a feature.</summary>
    /// <param name="feature">The feature.</param>
    /// <param name="theoretical">Its theoretical points in the feature's plane, in the order of <see cref="JobFeature.Points"/>.</param>
    /// <param name="actual">Its measured points, aligned, in the same order.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty of a measured coordinate.</param>
    /// <exception cref="ArgumentException">There are not as many points as the feature has.</exception>
    /// <exception cref="GeometryException">The points do not determine the feature; the message names it.</exception>
    public static FeatureEvaluation Evaluate(JobFeature feature, IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double standardUncertaintyMm)
    {
        ArgumentNullException.ThrowIfNull(feature);
        ArgumentNullException.ThrowIfNull(theoretical);
        ArgumentNullException.ThrowIfNull(actual);
        if (theoretical.Count != feature.Points.Count || actual.Count != feature.Points.Count)
        {
            throw new ArgumentException($"Found {theoretical.Count} theoretical and {actual.Count} measured points; expected {feature.Points.Count} of each.", nameof(actual));
        }

        return feature switch
        {
            LineFeature line => EvaluateLine(line, theoretical, actual, standardUncertaintyMm),
            TriangleFeature triangle => EvaluateTriangle(triangle, theoretical, actual, standardUncertaintyMm),
            _ => EvaluateCurve((CurveFeature)feature, theoretical, actual, standardUncertaintyMm),
        };
    }

    private static FeatureEvaluation EvaluateLine(LineFeature line, IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var wanted = FeatureFits.Line(line.Name, line.Method, theoretical, 0);
        var found = FeatureFits.Line(line.Name, line.Method, actual, u);
        return new(
            line.Name,
            line.Kind,
            [
                new(FeatureQuantity.Length, wanted.Length, found.Length, Math.Sqrt(2) * u),
                new(FeatureQuantity.Direction, wanted.Line.Direction.Direction.Normalized.Degrees, found.Line.Direction.Direction.Normalized.Degrees, found.AngleStandardError.Degrees),
            ],
            found.Residuals,
            null,
            null,
            []);
    }

    private static FeatureEvaluation EvaluateTriangle(TriangleFeature triangle, IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var first = triangle.FirstFlank.Count;
        var wanted = FeatureFits.Wedge(triangle.Name, [.. theoretical.Take(first)], [.. theoretical.Skip(first)], 0);
        var found = FeatureFits.Wedge(triangle.Name, [.. actual.Take(first)], [.. actual.Skip(first)], u);

        // A flank runs from the apex to a measured point; the apex may be off along it by no more than by its whole standard error.
        var flank = new Vector2(found.ApexStandardError.Length, u).Length;
        return new(
            triangle.Name,
            triangle.Kind,
            [
                new(FeatureQuantity.ApexX, wanted.Apex.X, found.Apex.X, found.ApexStandardError.X),
                new(FeatureQuantity.ApexY, wanted.Apex.Y, found.Apex.Y, found.ApexStandardError.Y),
                new(FeatureQuantity.IncludedAngle, wanted.IncludedAngle.Degrees, found.IncludedAngle.Degrees, found.IncludedAngleStandardError.Degrees),
                new(FeatureQuantity.FirstFlank, wanted.FirstLength, found.FirstLength, flank),
                new(FeatureQuantity.SecondFlank, wanted.SecondLength, found.SecondLength, flank),
            ],
            [.. found.First.Residuals, .. found.Second.Residuals],
            null,
            null,
            []);
    }

    private static FeatureEvaluation EvaluateCurve(CurveFeature curve, IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var options = new PolynomialFitOptions { Degree = curve.Degree, Ridge = curve.Ridge, PointUncertaintyMm = u };
        var chord = new FeatureQuantity(FeatureQuantity.Chord, theoretical[0].DistanceTo(theoretical[^1]), actual[0].DistanceTo(actual[^1]), Math.Sqrt(2) * u);
        var (wanted, found) = (Fit(curve, theoretical, options), Fit(curve, actual, options));
        if (wanted is null || found is null)
        {
            return new(curve.Name, curve.Kind, [chord], [], null, null, [.. Sparse(curve, Polyline(theoretical)), WarningForms.Warning(WarningForms.FoldedCurve, curve.Name)]);
        }

        var length = ArcLength(wanted);
        return new(
            curve.Name,
            curve.Kind,
            [chord, new(FeatureQuantity.ArcLength, length, ArcLength(found), Math.Sqrt(2) * u)],
            found.Residuals,
            wanted,
            found,
            Sparse(curve, length));
    }

    /// <summary>The fit, or null for a curve that is no function over its chord: its compensation works along the boundary and does not need one.</summary>
    private static CurveFit? Fit(CurveFeature curve, IReadOnlyList<Point2> points, PolynomialFitOptions options)
    {
        try
        {
            return FeatureFits.Named(curve.Name, () => CurveFit.Fit(points, options));
        }
        catch (GeometryException e) when (e.Error == GeometryError.FoldedCurve)
        {
            return null;
        }
    }

    /// <summary>Length of the fitted curve: the integral of sqrt(1 + f'^2) over its chord by Gauss-Legendre quadrature.</summary>
    private static double ArcLength(CurveFit curve) => GaussLegendreRule.Integrate(
        along => Math.Sqrt(1 + Math.Pow(curve.Polynomial.Derivative(along), 2)), 0, curve.Chord.Length, QuadratureOrder);

    private static double Polyline(IReadOnlyList<Point2> points) => points.Zip(points.Skip(1), (a, b) => a.DistanceTo(b)).Sum();

    private static List<ReportWarning> Sparse(CurveFeature curve, double lengthMm)
    {
        if (curve.Points.Count >= lengthMm / RecommendedSpacingMm)
        {
            return [];
        }

        var (count, length, spacing) = (curve.Points.Count.ToString(CultureInfo.InvariantCulture), lengthMm.ToString("0.#", CultureInfo.InvariantCulture), RecommendedSpacingMm.ToString(CultureInfo.InvariantCulture));
        return [WarningForms.Warning(WarningForms.SparsePoints, curve.Name, count, length, spacing)];
    }
}
