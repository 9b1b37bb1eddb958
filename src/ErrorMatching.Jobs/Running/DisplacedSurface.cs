using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>An existing finishing program displaced by the compensation, with its report.</summary>
/// <param name="Report">The report.</param>
public sealed record DisplacedSurface(DisplacementReport Report)
{
    /// <summary>The bytes of the program.</summary>
    public ReadOnlyMemory<byte> Program => Report.Displaced.Program.Bytes;

    /// <summary>The same with a program that is withheld if its verdict says not to cut it and is not accepted: then the report names no
    /// folder of the program.</summary>
    /// <param name="accepted">The codes that are accepted, or <see cref="Reporting.Acceptance.Any"/>.</param>
    public DisplacedSurface Obey(IReadOnlyCollection<string> accepted)
    {
        var report = Report with { Acceptance = ProfileWords.Obey(Report.Verdict, accepted) };
        return this with { Report = report.Acceptance.IsWithheld ? report with { Folder = null } : report };
    }

    /// <summary>The report as JSON: the document <c>errormatch/surface-displace/1</c>.</summary>
    public byte[] ReportJson() => DisplacementDocument.Of(Report).Write();

    /// <summary>The report as an HTML page.</summary>
    public byte[] ReportHtml() => DisplacementReportHtml.Write(Report);
}
