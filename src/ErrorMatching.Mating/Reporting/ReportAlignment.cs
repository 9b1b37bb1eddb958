using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>How one measurement was moved before it was compared.</summary>
/// <param name="Role">Whose measurement: the role of a <see cref="ReportInput"/>.</param>
/// <param name="Kind">How it was aligned.</param>
/// <param name="Transform">What was applied to the measured points.</param>
/// <param name="RmsMm">Root mean square of the distances that are left.</param>
/// <param name="MaxMm">The largest distance that is left.</param>
/// <param name="Residuals">Aligned - theoretical for each point.</param>
public sealed record ReportAlignment(
    string Role, JobAlignmentKind Kind, RigidTransform2 Transform, double RmsMm, double MaxMm, IReadOnlyList<ReportResidual> Residuals);
