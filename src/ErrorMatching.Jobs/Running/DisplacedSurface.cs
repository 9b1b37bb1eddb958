using ErrorMatching.Freeform;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>An existing finishing program displaced by the compensation, with its proof.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The input files.</param>
/// <param name="ProgramFile">The original program, as the caller named it.</param>
/// <param name="Displaced">The displaced program.</param>
/// <param name="Compensation">The compensation.</param>
/// <param name="Folder">The target folder; null if the program is not written, or the folder is unknown.</param>
public sealed record DisplacedSurface(
    ReportJob Job,
    IReadOnlyList<ReportInput> Inputs,
    string ProgramFile,
    DisplacedProgram Displaced,
    CompensationResult Compensation,
    string? Folder)
{
    /// <summary>File name of the program: that of the original program.</summary>
    public string Name => Path.GetFileName(ProgramFile);

    /// <summary>The program that cut the measured piece, if known.</summary>
    public MeasuredPieceProgram CutBy { get; init; } = new(null, null);

    /// <summary>The target path of the program.</summary>
    public string File => Path.Combine(Folder ?? "", Name);

    /// <summary>The bytes of the program.</summary>
    public ReadOnlyMemory<byte> Program => Displaced.Program.Bytes;

    /// <summary>The report as JSON: the document <c>errormatch/surface-displace/1</c>.</summary>
    public byte[] ReportJson() => DisplacementDocument.Of(this).Write();

    /// <summary>The report as an HTML page.</summary>
    public byte[] ReportHtml() => DisplacementReportHtml.Write(this);
}
