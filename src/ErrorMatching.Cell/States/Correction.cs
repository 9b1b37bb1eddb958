namespace ErrorMatching.Cell;

/// <summary>One incoming file and what became of it. Every file that arrives becomes one, whatever it is. Hashes are SHA-256 as 64 lower-case hexadecimal digits; what they name is in the store.</summary>
/// <param name="Id">Number in the store, in order of arrival.</param>
/// <param name="State">How far it has come.</param>
/// <param name="Version">Counts its changes; a step says which one it starts from.</param>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="ArrivedAt">When it was archived.</param>
/// <param name="MeasurementSha256">Its content.</param>
/// <param name="MeasurementBytes">Its length.</param>
public sealed record Correction(
    long Id, CorrectionState State, int Version, string Gauge, string FileName, DateTimeOffset ArrivedAt, string MeasurementSha256, long MeasurementBytes)
{
    /// <summary>Number of the correction that its measurement came in with, where it was given again to be computed anew; null where it came in with this one. A measurement that is given again is of the same job, piece and slot from the beginning.</summary>
    public long? MeasuredAs { get; init; }

    /// <summary>Says which of two measurements came first, and what stands before what in line: a measurement that is given again stays where it was.</summary>
    public long Turn => MeasuredAs ?? Id;

    /// <summary>When the last step was taken.</summary>
    public DateTimeOffset ChangedAt { get; init; }

    /// <summary>Name of the cell's job; null before it is recognized.</summary>
    public string? Job { get; init; }

    /// <summary>Whose measurement it is: <c>part</c>, <c>counterpart</c> or <c>surface</c>; null before it is recognized.</summary>
    public string? Piece { get; init; }

    /// <summary>Serial number of the piece; null if nothing says it.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order that came with the measurement; null if it says none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>The work order that the job names; null if it names none, and before it is recognized.</summary>
    public string? JobWorkOrder { get; init; }

    /// <summary>SHA-256 over measurement, job and base program: a correction of one identity is applied once. Null before it is recognized.</summary>
    public string? Identity { get; init; }

    /// <summary>The job's file.</summary>
    public string? JobSha256 { get; init; }

    /// <summary>The program that it starts from.</summary>
    public string? BaseSha256 { get; init; }

    /// <summary>The machine; null before it is recognized.</summary>
    public string? Machine { get; init; }

    /// <summary>The machine's slot.</summary>
    public string? Slot { get; init; }

    /// <summary>Name of the program at the machine; null before it is recognized.</summary>
    public string? Program { get; init; }

    /// <summary>The part's measurement that a counterpart is compared with; null for other pieces, and where no part is known.</summary>
    public string? PartSha256 { get; init; }

    /// <summary>The compensated program; null before it is computed.</summary>
    public string? ProgramSha256 { get; init; }

    /// <summary>The report as JSON: of the match or the compensation, or where a counterpart only verifies, of the verification.</summary>
    public string? ReportSha256 { get; init; }

    /// <summary>The report as a page.</summary>
    public string? PageSha256 { get; init; }

    /// <summary>The largest displacement of this step in mm.</summary>
    public double? LargestMm { get; init; }

    /// <summary>The largest sum of displacements since the original program in mm, where the job accumulates; else that of this step.</summary>
    public double? SumMm { get; init; }

    /// <summary>The sums of corrections since the original program, point by point, where the job accumulates; else null.</summary>
    public string? SumsSha256 { get; init; }

    /// <summary>What the slot held before the program was sent; null if it held nothing or nothing was sent yet.</summary>
    public string? PreviousSha256 { get; init; }

    /// <summary>Stable word for why it was refused, rejected, recorded or failed; else null.</summary>
    public string? Code { get; init; }

    /// <summary>The reason in a setter's words; null where there is none.</summary>
    public string? Reason { get; init; }

    /// <summary>The W3C trace that this correction is followed by from file to verified; null where nothing traces.</summary>
    public string? Trace { get; init; }
}
