using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>A finishing program generated for the compensated surface, with its report.</summary>
/// <param name="Program">The bytes of the program.</param>
/// <param name="Report">The compensation report.</param>
public sealed record FinishedSurface(ReadOnlyMemory<byte> Program, CompensationReport Report)
{
    /// <summary>File name of the program.</summary>
    public const string Name = "finishing.nc";

    /// <summary>The same with a program that is withheld if its verdict says not to cut it and is not accepted: then the report names no
    /// folder of the program.</summary>
    /// <param name="accepted">The codes that are accepted, or <see cref="Reporting.Acceptance.Any"/>.</param>
    public FinishedSurface Obey(IReadOnlyCollection<string> accepted)
    {
        var report = Report with { Acceptance = ProfileWords.Obey(Report.Verdict, accepted) };
        return this with
        {
            Report = report.Acceptance.IsWithheld ? report with { Program = report.Program with { File = Name } } : report,
        };
    }

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => CompensationDocument.Of(Report).Write();

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => CompensationReportHtml.Write(Report);
}
