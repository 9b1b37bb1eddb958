using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Size and shape of a feature from its points.</summary>
/// <param name="Quantities">The quantities of its kind.</param>
/// <param name="ResidualsMm">Residuals of the fit to the measured points, in their order; empty if there is no fit.</param>
/// <param name="Warnings">Warnings for the user.</param>
internal sealed record FeatureEvaluation(
    IReadOnlyList<FeatureQuantity> Quantities, IReadOnlyList<double> ResidualsMm, IReadOnlyList<ReportWarning> Warnings)
{
    /// <summary>The fit to a curve's measured points; null if the feature is not fitted by a polynomial.</summary>
    public CurveFit? Curve { get; init; }
}
