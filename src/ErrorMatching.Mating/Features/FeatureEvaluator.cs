using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Evaluates features as designed and as measured (Wang 2021, sections 2.1 to 2.4).</summary>
internal static class FeatureEvaluator
{
    /// <summary>Evaluates a feature.</summary>
    /// <param name="feature">The feature.</param>
    /// <param name="theoretical">Its theoretical points in the feature's plane, in the order of <see cref="JobFeature.Points"/>.</param>
    /// <param name="actual">Its measured points, aligned, in the same order.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty of a measured coordinate.</param>
    /// <exception cref="ArgumentException">The number of points is not that of the feature.</exception>
    /// <exception cref="GeometryException">The points do not determine the feature; the message names it.</exception>
    public static FeatureEvaluation Evaluate(
        JobFeature feature, IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double standardUncertaintyMm)
    {
        ArgumentNullException.ThrowIfNull(feature);
        ArgumentNullException.ThrowIfNull(theoretical);
        ArgumentNullException.ThrowIfNull(actual);
        if (theoretical.Count != feature.Points.Count || actual.Count != feature.Points.Count)
        {
            throw new ArgumentException(
                $"Found {theoretical.Count} theoretical and {actual.Count} measured points; expected {feature.Points.Count} of each.",
                nameof(actual));
        }

        return feature.Evaluate(theoretical, actual, standardUncertaintyMm);
    }
}
