using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What the points of a feature say about its size and shape.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Kind">What shape it is.</param>
/// <param name="Quantities">
/// Of a line: length between the extreme points projected on the fitted line, direction of cutting. Of a triangle: apex, included angle, lengths of both flanks from the apex.
/// Of a curve: length of its chord, length along its fit.
/// </param>
/// <param name="ResidualsMm">What the fit to the measured points leaves, in their order; empty where there is no fit.</param>
/// <param name="TheoreticalCurve">The fit to a curve's theoretical points; null for straight features and for curves that turn back over their chord.</param>
/// <param name="ActualCurve">The fit to a curve's measured points; null for straight features and for curves that turn back over their chord.</param>
/// <param name="Warnings">What a person should know.</param>
internal sealed record FeatureEvaluation(
    string Feature,
    FeatureKind Kind,
    IReadOnlyList<FeatureQuantity> Quantities,
    IReadOnlyList<double> ResidualsMm,
    CurveFit? TheoreticalCurve,
    CurveFit? ActualCurve,
    IReadOnlyList<ReportWarning> Warnings);
