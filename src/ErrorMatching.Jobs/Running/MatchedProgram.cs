using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>A counterpart's program that follows the measured piece, and its report.</summary>
/// <param name="Match">The match.</param>
/// <param name="Report">What it has to say.</param>
public sealed record MatchedProgram(MatchResult Match, MatchReport Report)
{
    /// <summary>Name of the program, without folders: that of the program that it starts from.</summary>
    public string Name => Path.GetFileName(Match.Input.ProgramFile);

    /// <summary>The bytes of the program to cut.</summary>
    public ReadOnlyMemory<byte> Program => Match.Program;

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => MatchReportJson.Write(Report);

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => MatchReportHtml.Write(Report);
}
