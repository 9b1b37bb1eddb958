using System.Text.Encodings.Web;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>A displaced finishing program as a document, <c>errormatch/surface-displace/1</c>.</summary>
/// <remarks>UTF-8 without a byte order mark, ending with a newline.</remarks>
public sealed record DisplacementDocument
{
    /// <summary>Name of the schema.</summary>
    public const string Schema = "errormatch/surface-displace/1";

    /// <summary>The job's name.</summary>
    public required string JobName { get; init; }

    /// <summary>The original program, as the caller named it.</summary>
    public required string Program { get; init; }

    /// <summary>The target path of the program; null if it was not written.</summary>
    public required string? File { get; init; }

    /// <summary>Number of points that touch the surface.</summary>
    public required int OnSurface { get; init; }

    /// <summary>Number of points near by that follow.</summary>
    public required int Followed { get; init; }

    /// <summary>The largest displacement.</summary>
    public required double LargestMoveMm { get; init; }

    /// <summary>By how much a straight cut misses the compensation, at most.</summary>
    public required double LargestMisfitMm { get; init; }

    /// <summary>Number of blocks that differ.</summary>
    public required int ChangedBlocks { get; init; }

    /// <summary>Number of words that differ.</summary>
    public required int ChangedWords { get; init; }

    /// <summary>What was proved about the program; the document names no neighbors.</summary>
    public required ReportProof Proof { get; init; }

    /// <summary>What was measured, compensated and predicted.</summary>
    public required SurfaceFindings Findings { get; init; }

    /// <summary>What became of a program that the verdict says not to cut.</summary>
    public Acceptance Acceptance { get; init; } = Acceptance.None;

    /// <summary>Warnings, in sentences.</summary>
    public required IReadOnlyList<ReportWarning> Warnings { get; init; }

    /// <summary>Notes, in sentences.</summary>
    public required IReadOnlyList<string> Notes { get; init; }

    /// <summary>The document of a displaced program.</summary>
    public static DisplacementDocument Of(DisplacementReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        var (displaced, proof) = (report.Displaced, report.Displaced.Proof);
        return new()
        {
            JobName = report.Job.Name,
            Program = report.ProgramFile,
            File = report.Folder is null ? null : report.File,
            OnSurface = displaced.OnSurface,
            Followed = displaced.Followed,
            LargestMoveMm = displaced.LargestMoveMm,
            LargestMisfitMm = displaced.LargestMisfitMm,
            ChangedBlocks = displaced.Rewrite.ChangedBlocks.Count,
            ChangedWords = displaced.Rewrite.ChangedWords,
            Proof = new(
                proof.Holds,
                proof.Motions,
                proof.MovedMotions,
                [],
                proof.Marker,
                proof.MaxDeviationFromWantedMm,
                proof.UntouchedBytesIdentical),
            Findings = SurfaceFindings.Of(report.Compensation, report.CutBy),
            Acceptance = report.Acceptance,
            Warnings = report.Compensation.Warnings,
            Notes = report.Compensation.Notes,
        };
    }

    /// <summary>Writes the document.</summary>
    // File names are not escaped: the document is UTF-8 and is not embedded in a web page.
    public byte[] Write() => ReportWriter.Document(Schema, Write, JavaScriptEncoder.UnsafeRelaxedJsonEscaping);

    /// <summary>Reads a document. Older ones lack the marker.</summary>
    /// <param name="document">The document, of this schema.</param>
    /// <returns>The document; null if it is older than the map.</returns>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static DisplacementDocument? Read(ReportReader document)
    {
        ArgumentNullException.ThrowIfNull(document);
        return SurfaceFindings.Read(document) is not { } findings ? null : new()
        {
            JobName = document.Text("job"),
            Program = document.Text("program"),
            File = document.OptionalText("file"),
            OnSurface = document.Count("onSurface"),
            Followed = document.Count("followed"),
            LargestMoveMm = document.Number("largestMoveMm"),
            LargestMisfitMm = document.Number("largestMisfitMm"),
            ChangedBlocks = document.Count("changedBlocks"),
            ChangedWords = document.Count("changedWords"),
            Proof = ReportProof.Read(document.Object("proof")),
            Findings = findings,
            Acceptance = Acceptance.Read(document),
            Warnings = document.Warnings(),
            Notes = document.Texts("notes"),
        };
    }

    private void Write(ReportWriter json)
    {
        json.Text("job", JobName);
        json.Text("program", Program);
        json.Text("file", File);
        json.Count("onSurface", OnSurface);
        json.Count("followed", Followed);
        json.Exact("largestMoveMm", LargestMoveMm);
        json.Exact("largestMisfitMm", LargestMisfitMm);
        json.Count("changedBlocks", ChangedBlocks);
        json.Count("changedWords", ChangedWords);
        json.Object("proof", () =>
        {
            json.Flag("holds", Proof.Holds);
            json.Count("motions", Proof.Motions);
            json.Count("movedMotions", Proof.MovedMotions);
            json.Text("marker", Proof.Marker);
            json.Exact("maxDeviationFromWantedMm", Proof.MaxDeviationFromWantedMm);
            json.Flag("untouchedBytesIdentical", Proof.UntouchedBytesIdentical);
        });
        Findings.Write(json);
        Acceptance.Write(json);
        json.Warnings(Warnings);
        json.Texts("notes", Notes);
    }
}
