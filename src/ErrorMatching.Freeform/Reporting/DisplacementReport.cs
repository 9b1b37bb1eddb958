using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The content of a report on an existing finishing program that the compensation displaced.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The input files.</param>
/// <param name="ProgramFile">The original program, as the caller named it.</param>
/// <param name="Displaced">The displaced program.</param>
/// <param name="Compensation">The compensation.</param>
/// <param name="Folder">The target folder; null if the program is not written, or the folder is unknown.</param>
public sealed record DisplacementReport(
    ReportJob Job,
    IReadOnlyList<ReportInput> Inputs,
    string ProgramFile,
    DisplacedProgram Displaced,
    CompensationResult Compensation,
    string? Folder)
{
    /// <summary>File name of the program: that of the original program.</summary>
    public string Name => Path.GetFileName(ProgramFile);

    /// <summary>The verdict by the job's profile tolerance, calculated at each call; null if the job states none.</summary>
    public SurfaceVerdict? Verdict => Compensation.Verdict();

    /// <summary>What became of a program that the verdict says not to cut.</summary>
    public Acceptance Acceptance { get; init; } = Acceptance.None;

    /// <summary>The program that cut the measured piece, if known.</summary>
    public MeasuredPieceProgram CutBy { get; init; } = new(null, null);

    /// <summary>The target path of the program.</summary>
    public string File => PathText.In(Folder, Name);
}
