using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>An incoming file and its result. Every file that arrives becomes a correction, whatever it is. Hashes are SHA-256 as 64
/// lowercase hexadecimal digits; the store holds what they name.</summary>
/// <param name="Id">Number in the store, in order of arrival.</param>
/// <param name="State">Its current state.</param>
/// <param name="Version">Number of changes so far. A step names the version that it starts from.</param>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="ArrivedAt">When it was archived.</param>
/// <param name="MeasurementSha256">Hash of its content.</param>
/// <param name="MeasurementBytes">Its length.</param>
public sealed record Correction(
    long Id,
    CorrectionState State,
    int Version,
    string Gauge,
    string FileName,
    DateTimeOffset ArrivedAt,
    string MeasurementSha256,
    long MeasurementBytes)
{
    /// <summary>Number of the correction that its measurement arrived with, if this one recalculates it; null if it arrived with this
    /// one. One that recalculates has the same job, piece and slot from the start.</summary>
    public long? MeasuredAs { get; init; }

    /// <summary>Decides which of two measurements came first, and the order in line. One that recalculates has
    /// the place of the first.</summary>
    public long Turn => MeasuredAs ?? Id;

    /// <summary>When the last step was taken.</summary>
    public DateTimeOffset ChangedAt { get; init; }

    /// <summary>Name of the cell's job; null before it is recognized.</summary>
    public string? Job { get; init; }

    /// <summary>The piece that it measures: <c>part</c>, <c>counterpart</c> or <c>surface</c>; null before it is recognized.</summary>
    public string? Piece { get; init; }

    /// <summary>Serial number of the piece; null if unknown.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order that came with the measurement; null if there is none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>The work order that the job names; null if there is none, and before it is recognized.</summary>
    public string? JobWorkOrder { get; init; }

    /// <summary>SHA-256 over measurement, job and base program. A correction with a given identity is applied once. Null before it is
    /// recognized.</summary>
    public string? Identity { get; init; }

    /// <summary>The job's file.</summary>
    public string? JobSha256 { get; init; }

    /// <summary>The base program.</summary>
    public string? BaseSha256 { get; init; }

    /// <summary>The machine; null before it is recognized.</summary>
    public string? Machine { get; init; }

    /// <summary>The machine's slot.</summary>
    public string? Slot { get; init; }

    /// <summary>Name of the program at the machine; null before it is recognized.</summary>
    public string? Program { get; init; }

    /// <summary>The part's measurement that a counterpart is compared with; null for other pieces, or if no part is known.</summary>
    public string? PartSha256 { get; init; }

    /// <summary>The compensated program; null before it is computed.</summary>
    public string? ProgramSha256 { get; init; }

    /// <summary>The report as JSON: of the match or the compensation, or of the verification if a counterpart is only verified.</summary>
    public string? ReportSha256 { get; init; }

    /// <summary>The report as a page.</summary>
    public string? PageSha256 { get; init; }

    /// <summary>The largest displacement of this step in mm.</summary>
    public double? LargestMm { get; init; }

    /// <summary>The largest sum of displacements since the original program in mm, if the job accumulates; else that of this
    /// step.</summary>
    public double? SumMm { get; init; }

    /// <summary>The sums of corrections since the original program, point by point, if the job accumulates; else null.</summary>
    public string? SumsSha256 { get; init; }

    /// <summary>What the program sets, if it is one that sets offsets of the control: which offset, the step, and the correction in all;
    /// null if the program is one that cuts.</summary>
    public Statement? Offset { get; init; }

    /// <summary>The program that takes an offset back; null if <see cref="Offset"/> is.</summary>
    public string? UndoSha256 { get; init; }

    /// <summary>What a revert brings to the slot: the program that takes the offset back, or what the slot held before. Null if there is
    /// nothing to bring back.</summary>
    public string? RevertedSha256 => UndoSha256 ?? PreviousSha256;

    /// <summary>What the slot held before the program was sent; null if it held nothing or nothing was sent yet.</summary>
    public string? PreviousSha256 { get; init; }

    /// <summary>Stable code for why it was refused, rejected, recorded or failed; else null.</summary>
    public string? Code { get; init; }

    /// <summary>The reason in a setter's terms; null if there is none.</summary>
    public Statement? Reason { get; init; }

    /// <summary>True if it waits for a person's decision: to be approved or rejected.</summary>
    public bool IsUndecided => CorrectionSteps.Of(State).IsUndecided;

    /// <summary>True if cutting is still a question: its program is proposed, at the machine, or on its way there.</summary>
    public bool IsToBeCut => CorrectionSteps.Of(State) is { NamesProgram: true, IsSettled: false };

    /// <summary>True if its slot, while it has one, may be released by an operator.</summary>
    public bool WaitsForRelease => CorrectionSteps.Of(State).WaitsForRelease;

    /// <summary>True if a person or a newer measurement decided against it, so that its piece does not count.</summary>
    public bool IsSetAside => CorrectionSteps.Of(State).IsSetAside;

    /// <summary>The W3C trace that follows this correction from file to verified; null without tracing.</summary>
    public string? Trace { get; init; }
}

/// <summary>One step of a correction.</summary>
/// <param name="Correction">Its number.</param>
/// <param name="From">The state before; null for the arrival.</param>
/// <param name="To">The state after.</param>
/// <param name="At">When.</param>
/// <param name="By">The user's name, or <c>cell</c> for what the cell does by its policy.</param>
/// <param name="Basis">The basis: the policy's rule, a person's reason, the machine's response.</param>
public sealed record CorrectionStep(long Correction, CorrectionState? From, CorrectionState To, DateTimeOffset At, string By,
    Statement Basis);

/// <summary>The pieces that a measurement can be of, as <see cref="Correction.Piece"/> and the store have them.</summary>
public static class PieceWords
{
    /// <summary>The part of a mating.</summary>
    public const string Part = "part";

    /// <summary>The counterpart of a mating.</summary>
    public const string Counterpart = "counterpart";

    /// <summary>A free-form surface.</summary>
    public const string Surface = "surface";
}
