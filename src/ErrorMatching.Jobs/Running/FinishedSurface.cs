using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>A finishing program that was made for the compensated surface, and its report.</summary>
/// <param name="Program">The bytes of the program.</param>
/// <param name="Report">What the compensation has to say.</param>
public sealed record FinishedSurface(ReadOnlyMemory<byte> Program, CompensationReport Report)
{
    /// <summary>Name of the program, without folders.</summary>
    public const string Name = "finishing.nc";

    /// <summary>The report as <c>report.json</c>.</summary>
    public byte[] ReportJson() => CompensationReportJson.Write(Report);

    /// <summary>The report as <c>report.html</c>.</summary>
    public byte[] ReportHtml() => CompensationReportHtml.Write(Report);
}
