using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>An existing finishing program displaced by the compensation, with its report.</summary>
/// <param name="Report">The report.</param>
public sealed record DisplacedSurface(DisplacementReport Report)
{
    /// <summary>The bytes of the program.</summary>
    public ReadOnlyMemory<byte> Program => Report.Displaced.Program.Bytes;

    /// <summary>The report as JSON: the document <c>errormatch/surface-displace/1</c>.</summary>
    public byte[] ReportJson() => DisplacementDocument.Of(Report).Write();

    /// <summary>The report as an HTML page.</summary>
    public byte[] ReportHtml() => DisplacementReportHtml.Write(Report);
}
