using ErrorMatching.Freeform;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>An existing finishing program that follows the compensation, with its proof.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The files that it was made from.</param>
/// <param name="ProgramFile">The program that it starts from, as the caller named it.</param>
/// <param name="Displaced">What became of it.</param>
/// <param name="Compensation">What it follows.</param>
/// <param name="Folder">The folder that it will stand in; null if it is not written, or nobody knows where.</param>
public sealed record DisplacedSurface(ReportJob Job, IReadOnlyList<ReportInput> Inputs, string ProgramFile, DisplacedProgram Displaced, CompensationResult Compensation, string? Folder)
{
    /// <summary>Name of the program, without folders: that of the program that it starts from.</summary>
    public string Name => Path.GetFileName(ProgramFile);

    /// <summary>Which program cut the measured piece, as far as anybody said.</summary>
    public MeasuredPieceProgram CutBy { get; init; } = new(null, null);

    /// <summary>Where the program goes.</summary>
    public string File => Path.Combine(Folder ?? "", Name);

    /// <summary>The bytes of the program.</summary>
    public ReadOnlyMemory<byte> Program => Displaced.Program.Bytes;

    /// <summary>The report as JSON: the document <c>errormatch/surface-displace/1</c>.</summary>
    public byte[] ReportJson() => DisplacementReportJson.Write(this);

    /// <summary>The report as a page.</summary>
    public byte[] ReportHtml() => DisplacementReportHtml.Write(this);
}
