using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The alignment of one measurement before comparison.</summary>
/// <param name="Role">The measurement's role, as in <see cref="ReportInput"/>.</param>
/// <param name="Kind">Kind of alignment.</param>
/// <param name="Transform">Transform of the measured points.</param>
/// <param name="RmsMm">Root mean square of the remaining distances.</param>
/// <param name="MaxMm">The largest remaining distance.</param>
/// <param name="Residuals">Aligned - theoretical for each point.</param>
public sealed record ReportAlignment(
    string Role, JobAlignmentKind Kind, RigidTransform2 Transform, double RmsMm, double MaxMm, IReadOnlyList<ReportResidual> Residuals);
