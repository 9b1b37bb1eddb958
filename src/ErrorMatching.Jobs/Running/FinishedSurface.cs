using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>A finishing program generated for the compensated surface, with its report.</summary>
/// <param name="Program">The bytes of the program.</param>
/// <param name="Report">The compensation report.</param>
public sealed record FinishedSurface(ReadOnlyMemory<byte> Program, CompensationReport Report)
{
    /// <summary>File name of the program.</summary>
    public const string Name = "finishing.nc";

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => CompensationDocument.Of(Report).Write();

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => CompensationReportHtml.Write(Report);
}
