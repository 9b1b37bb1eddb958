using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What the points of a feature say about its size and shape.</summary>
/// <param name="Quantities">The quantities of its kind.</param>
/// <param name="ResidualsMm">What the fit to the measured points leaves, in their order; empty where there is no fit.</param>
/// <param name="Warnings">What a person should know.</param>
internal sealed record FeatureEvaluation(
    IReadOnlyList<FeatureQuantity> Quantities, IReadOnlyList<double> ResidualsMm, IReadOnlyList<ReportWarning> Warnings)
{
    /// <summary>The fit to a curve's measured points; null for what is no polynomial.</summary>
    public CurveFit? Curve { get; init; }
}
