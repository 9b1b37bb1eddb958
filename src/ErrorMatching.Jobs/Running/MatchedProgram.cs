using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>A counterpart's program that follows the measured piece, with its report.</summary>
/// <param name="Match">The match.</param>
/// <param name="Report">The report.</param>
public sealed record MatchedProgram(MatchResult Match, MatchReport Report)
{
    /// <summary>File name of the program: that of the original program.</summary>
    public string Name { get; init; } = Path.GetFileName(Match.Input.ProgramFile);

    /// <summary>The bytes of the program to cut.</summary>
    public ReadOnlyMemory<byte> Program => Match.Program;

    /// <summary>The verdicts that may be accepted, by their codes.</summary>
    public static IReadOnlyList<string> Acceptable { get; } = [
        .. Enum.GetValues<VerdictCode>()
            .Where(c => c is not (VerdictCode.Within or VerdictCode.NoLimits or VerdictCode.CheckOrigin
                or VerdictCode.NotKnownBetween or VerdictCode.ProofFails))
            .Select(ReportWords.Of)];

    /// <summary>The same with a program that is withheld if its verdict says not to cut it and is not accepted: then the report names no
    /// folder of the program.</summary>
    /// <param name="accepted">The codes that are accepted, or <see cref="Acceptance.Any"/>.</param>
    public MatchedProgram Obey(IReadOnlyCollection<string> accepted)
    {
        var acceptance = Acceptance.Of(ReportWords.Of(Report.Verdict.Code), Report.Verdict.IsToCut, accepted);
        var report = Report with { Acceptance = acceptance };
        return this with
        {
            Report = !acceptance.IsWithheld ? report : report with
            {
                Program = report.Program with { File = Name },
                Correction = report.Correction is { File: { } file } correction
                    ? correction with { File = Path.GetFileName(file) }
                    : report.Correction,
            },
        };
    }

    /// <summary>The files of a folder: both reports, then the program, and before it that of the offsets if there is one. Without the
    /// programs if the verdict says not to cut and is not accepted. The program is last: if it exists, so does its report.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="accepted">The codes of verdicts that are accepted, or <see cref="Acceptance.Any"/>; none if null.</param>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> FilesIn(string folder, IReadOnlyCollection<string>? accepted = null)
    {
        var obedient = Obey(accepted ?? []);
        var files = new List<(string Path, ReadOnlyMemory<byte> Bytes)>
        {
            (PathText.In(folder, "report.json"), obedient.ReportJson()),
            (PathText.In(folder, "report.html"), obedient.ReportHtml()),
        };
        if (obedient.Report.Acceptance.IsWithheld)
        {
            return files;
        }

        if (Match.Correction?.Program is { } offsets)
        {
            files.Add((PathText.In(folder, Path.GetFileName(Report.Correction!.File!)), offsets));
        }

        files.Add((PathText.In(folder, Name), Program));
        return files;
    }

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => MatchReportJson.Write(Report);

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => MatchReportHtml.Write(Report);
}
