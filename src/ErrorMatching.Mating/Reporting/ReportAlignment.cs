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
    string Role, JobAlignmentKind Kind, RigidTransform2 Transform, double RmsMm, double MaxMm, IReadOnlyList<ReportResidual> Residuals)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("of", Role);
        w.Text("kind", ReportWords.Of(Kind));
        w.Object("transform", () =>
        {
            w.Text("mirror", ReportWords.Of(Transform.Mirror));
            w.Number("rotateDeg", Transform.Rotation.Degrees);
            w.Numbers("translateMm", [Transform.Translation.X, Transform.Translation.Y]);
        });
        w.Number("rmsMm", RmsMm);
        w.Number("maxMm", MaxMm);
        w.List("residuals", Residuals, r =>
        {
            w.Text("point", r.Point);
            w.Vector(r.Left);
        });
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportAlignment Read(ReportReader r)
    {
        var transform = r.Object("transform");
        var translate = transform.Numbers("translateMm", 2);
        return new(
            r.Text("of"),
            r.Word<JobAlignmentKind>("kind", ReportWords.Of),
            new(
                transform.Word<Mirror>("mirror", ReportWords.Of),
                Angle.FromDegrees(transform.Number("rotateDeg")),
                new(translate[0], translate[1])),
            r.Number("rmsMm"),
            r.Number("maxMm"),
            r.List("residuals", p => new ReportResidual(p.Text("point"), p.Vector())));
    }
}
