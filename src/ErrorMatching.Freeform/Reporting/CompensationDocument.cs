using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A compensation with a generated program as a document, <c>errormatch/surface-compensate/1</c>.</summary>
/// <remarks>In millimeters, or in micrometers if the key says so. UTF-8 without a byte order mark, lines end with a line feed.</remarks>
public sealed record CompensationDocument
{
    /// <summary>Name of the schema.</summary>
    public const string Schema = "errormatch/surface-compensate/1";

    /// <summary>The job.</summary>
    public required ReportJob Job { get; init; }

    /// <summary>The input files.</summary>
    public required IReadOnlyList<ReportInput> Inputs { get; init; }

    /// <summary>What was measured, compensated and predicted.</summary>
    public required SurfaceFindings Findings { get; init; }

    /// <summary>What became of a program that the verdict says not to cut.</summary>
    public Acceptance Acceptance { get; init; } = Acceptance.None;

    /// <summary>The tool path for the compensated surface.</summary>
    public required ToolPathFigures ToolPath { get; init; }

    /// <summary>The finishing program's file as written.</summary>
    public required string ProgramFile { get; init; }

    /// <summary>SHA-256 of the program.</summary>
    public required string ProgramSha256 { get; init; }

    /// <summary>True if the program calls its tool, false if it stops with an alarm instead; null in older reports.</summary>
    public required bool? CallsTool { get; init; }

    /// <summary>Warnings, in sentences.</summary>
    public required IReadOnlyList<ReportWarning> Warnings { get; init; }

    /// <summary>Notes, in sentences.</summary>
    public required IReadOnlyList<string> Notes { get; init; }

    /// <summary>Calculation time in seconds; null if it was not measured.</summary>
    public required double? CalculatingS { get; init; }

    /// <summary>The document of a report.</summary>
    public static CompensationDocument Of(CompensationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return new()
        {
            Job = report.Job,
            Inputs = report.Inputs,
            Findings = SurfaceFindings.Of(report.Result, report.CutBy),
            Acceptance = report.Acceptance,
            ToolPath = ToolPathFigures.Of(report.ToolPath),
            ProgramFile = report.Program.File,
            ProgramSha256 = report.Program.Sha256,
            CallsTool = report.CallsTool,
            Warnings = report.Warnings,
            Notes = report.Result.Notes,
            CalculatingS = report.CalculatingS,
        };
    }

    /// <summary>Writes the document.</summary>
    public byte[] Write() => ReportWriter.Document(Schema, json =>
    {
        json.Job("freeform", Job);
        json.Inputs(Inputs);
        Findings.Write(json);
        Acceptance.Write(json);
        json.Object("toolpath", () => ToolPath.Write(json));
        json.Object("program", () =>
        {
            json.Text("file", ProgramFile);
            json.Text("sha256", ProgramSha256);
            if (CallsTool is { } calls)
            {
                json.Flag("toolCall", calls);
            }
        });
        json.Warnings(Warnings);
        json.Texts("notes", Notes);
        json.Object("time", () => json.Number("calculatingS", CalculatingS));
    });

    /// <summary>Reads a document.</summary>
    /// <param name="document">The document, of this schema.</param>
    /// <returns>The document; null if it is older than the map.</returns>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static CompensationDocument? Read(ReportReader document)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (SurfaceFindings.Read(document) is not { } findings)
        {
            return null;
        }

        var program = document.Object("program");
        return new()
        {
            Job = document.Job(),
            Inputs = document.Inputs(),
            Findings = findings,
            Acceptance = Acceptance.Read(document),
            ToolPath = ToolPathFigures.Read(document.Object("toolpath")),
            ProgramFile = program.Text("file"),
            ProgramSha256 = program.Text("sha256"),
            CallsTool = program.OptionalFlag("toolCall"),
            Warnings = document.Warnings(),
            Notes = document.Texts("notes"),
            CalculatingS = document.OptionalObject("time")?.OptionalNumber("calculatingS"),
        };
    }
}
