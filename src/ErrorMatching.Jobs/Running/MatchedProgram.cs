using ErrorMatching.Mating;

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

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => MatchReportJson.Write(Report);

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => MatchReportHtml.Write(Report);
}
