using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>How well two counterparts fit the part.</summary>
/// <param name="report">The report.</param>
/// <param name="piece">The verified counterpart, for other systems.</param>
/// <param name="folder">The folder that it was written to; null if nothing was written.</param>
/// <param name="isRequired">True if a piece that is not in tolerance must not be used.</param>
internal sealed class VerifyAnswer(VerifyReport report, PieceResult piece, string? folder, bool isRequired) : Answer
{
    private readonly byte[] _json = VerifyReportJson.Write(report);

    public override Failure? Failure => isRequired && report.Verdict.IsInTolerance != true
        ? new(ExitCode.Refused, new Refusal("out-of-tolerance", $"{After}: {VerifyWords.Of(report.Verdict)}", new() { File = After }))
        : null;

    public override byte[] ToJson() => OutcomeWriter.WithErrors(_json, Failure);

    private string After => ReportInputs.Find(report.Inputs, "counterpart-after")!.File;

    /// <summary>The files to write.</summary>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Files =>
        [
            (In("verify.json"), _json),
            (In("verify.html"), VerifyReportHtml.Write(report)),
            (In("verify.qif"), QifWriter.Write(piece)),
            (In("verify.dfq"), AqdefWriter.Write(piece)),
        ];

    public override void WriteText(Page page)
    {
        var verdict = report.Verdict;
        page.Verdict(VerifyWords.Of(verdict), verdict.IsInTolerance);
        if (VerifyWords.Risk(verdict) is { } risk)
        {
            page.Line(risk);
        }

        if (report.Pair is { } pair)
        {
            page.Line(VerifyWords.Of(pair, report));
        }

        page.Line();
        page.Line(
            report.IsBeforeMeasured
                ? $"{report.Job.Name}: the largest mating error was {Show.Mm(report.Result.MaxBeforeMm)} mm before and is "
                    + $"{Show.Mm(report.Result.MaxAfterMm)} mm after"
                : $"{report.Job.Name}: the largest mating error is {Show.Mm(report.Result.MaxAfterMm)} mm; of the counterpart as designed "
                    + $"it would be {Show.Mm(report.Result.MaxBeforeMm)} mm");
        page.Line();
        page.Table(
            ["feature", "quantity", "wanted", "before", "after", "better by"],
            report.Result.Features.Select(f => (IReadOnlyList<string>)
                [
                    f.Name,
                    f.Quantity.Word,
                    Show.Mm(f.Wanted),
                    Show.Mm(f.Before),
                    Show.Mm(f.After),
                    report.IsBeforeMeasured ? ImprovementWords.Of(f, Show.Percent, "-") : "-"]));
        page.Line(
            "Lengths in mm, angles in degrees. Wanted is the part's value; deviations are the largest of their points, counterpart - "
                + "part.");
        foreach (var sentence in report.IsBeforeMeasured ? ImprovementWords.Legend(report.Result.Features) : [])
        {
            page.Line(sentence);
        }

        page.Line();
        page.Table(
            ["point", "before dx", "dy", "along normal", "after dx", "dy", "along normal"],
            report.Result.Points.Select(p => (IReadOnlyList<string>)
            [
                p.Label,
                Show.Signed(p.BeforeError.Vector.X), Show.Signed(p.BeforeError.Vector.Y), Show.Signed(p.BeforeError.NormalMm),
                Show.Signed(p.AfterError.Vector.X), Show.Signed(p.AfterError.Vector.Y), Show.Signed(p.AfterError.NormalMm),
            ]));
        page.Line("Along the normal: positive where the pieces overlap, negative where a gap is left.");
        foreach (var warning in report.Warnings)
        {
            page.Warning(warning);
        }

        page.Line();
        page.Line(
            folder is null
                ? "Nothing was written. Add --out DIR to write verify.json and verify.html, and verify.qif and verify.dfq for other "
                    + "systems."
                : $"Wrote {In("verify.html")}, {In("verify.json")}, {In("verify.qif")} and {In("verify.dfq")}.");
    }

    private string In(string name) => PathText.In(folder, name);
}
