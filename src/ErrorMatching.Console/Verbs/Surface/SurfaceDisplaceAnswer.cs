using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A finishing program displaced by the compensation.</summary>
/// <param name="surface">The program with its report.</param>
/// <param name="failure">Why no program is written; null if it is.</param>
internal sealed class SurfaceDisplaceAnswer(DisplacedSurface surface, Failure? failure) : Answer
{
    public override Failure? Failure => failure;

    public override byte[] ToJson() => OutcomeWriter.WithErrors(surface.ReportJson(), Failure);

    public override void WriteText(Page page)
    {
        var report = surface.Report;
        var (displaced, compensation) = (report.Displaced, report.Compensation);
        page.Verdict(ProfileLead.Of(compensation, report.Verdict), report.Verdict?.Predicted.IsWithin);
        if (report.Acceptance.Sentence is { } accepted)
        {
            page.Line(accepted);
        }

        page.Line();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"{report.Job.Name}: {ReportNumber.Count(displaced.OnSurface, "point of", "points of")} {report.ProgramFile} "
                + $"{(displaced.OnSurface == 1 ? "follows" : "follow")} the compensation, by at most "
                + $"{displaced.LargestMoveMm * 1000:0.00} µm; {displaced.Followed} near by go along"));
        page.Line();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Between two points a straight cut misses the compensation by at most {displaced.LargestMisfitMm * 1000:0.00} µm."));
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Proof holds: of {ReportNumber.Count(displaced.Proof.Motions, "motion")} {displaced.Proof.MovedMotions} moved, "
                + $"none further than "
                + $"{displaced.Proof.MaxDeviationFromWantedMm:0.0000} mm from where it was wanted; every byte besides is the "
                + $"original's{(displaced.Marker is null ? "" : ", but for the marker comment")}."));
        page.Line("Measured piece: " + report.CutBy.Sentence);
        if (compensation.Input.Job is { Profile: { } tolerance, Measuring.UncertaintyMm: var uncertainty })
        {
            page.Line("Tolerance: " + ProfileWords.Of(tolerance, uncertainty));
        }

        page.Line("Alignment: " + AlignmentWords.Of(compensation.Alignment));
        foreach (var warning in compensation.Warnings)
        {
            page.Warning(warning.ToString());
        }

        foreach (var note in compensation.Notes)
        {
            page.Line("Note: " + note);
        }

        page.Line();
        page.Line(
            report.Acceptance.IsWithheld
                ? "Nothing was written."
                : report.Folder is null
                ? "Nothing was written. Add --out DIR to write the program."
                : $"Wrote {report.File}. Next: cut with it, measure again, and compare by errormatch surface evaluate.");
    }
}
