using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The result of a measurement: <see cref="Identified"/> before it is computed, then a <see cref="ComputedProgram"/> or
/// <see cref="NothingToSend"/>; at any time a <see cref="RefusedComputation"/>.</summary>
public abstract record Computation;

/// <summary>The inputs of a correction, before it is computed.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
internal sealed record Identified(CorrectionBasis Basis) : Computation;

/// <summary>A readable measurement that needs no program: it is kept as evidence.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
/// <param name="Code">Stable code: one of <see cref="CorrectionCodes"/>.</param>
/// <param name="Reason">Why nothing is sent, in a setter's terms.</param>
internal sealed record NothingToSend(CorrectionBasis Basis, string Code, Statement Reason) : Computation
{
    /// <summary>How well a counterpart fits its part, as JSON (<c>errormatch/verify/1</c>); null if nothing was compared.</summary>
    public ReadOnlyMemory<byte>? Report { get; init; }

    /// <summary>The report as a page; null if nothing was compared.</summary>
    public ReadOnlyMemory<byte>? Page { get; init; }

    /// <summary>True if the page was drawn from the report alone.</summary>
    public bool IsPageOfReport { get; init; }
}

/// <summary>Why no program may be made from a measurement.</summary>
/// <param name="Code">Stable code: one of <see cref="CorrectionCodes"/>, or the console's code for the same inputs.</param>
/// <param name="Reason">The problem and what to do, in a setter's terms.</param>
public sealed record RefusedComputation(string Code, Statement Reason) : Computation
{
    /// <summary>The block concerned as the setter knows it, such as <c>N110</c>; null for none.</summary>
    public string? Block { get; init; }

    /// <summary>True if the cause is not the measurement but a file of the job that cannot be opened now: a later attempt may
    /// succeed.</summary>
    public bool MayPass { get; init; }
}

/// <summary>The inputs that a correction is based on. Hashes are SHA-256 as 64 lowercase hexadecimal digits.</summary>
/// <param name="Identity">The correction's identity (<see cref="CorrectionIdentity"/>).</param>
/// <param name="JobSha256">The job's file.</param>
/// <param name="Job">Its content.</param>
/// <param name="BaseSha256">The base program; null if the program is generated.</param>
/// <param name="Base">Its content; null if the program is generated.</param>
/// <param name="WorkOrder">The work order that the job names; null if there is none.</param>
public sealed record CorrectionBasis(
    string Identity, string JobSha256, ReadOnlyMemory<byte> Job, string? BaseSha256, ReadOnlyMemory<byte>? Base, string? WorkOrder);

/// <summary>A program that may be proposed, with the data that people need for a decision. The same inputs give the same bytes.</summary>
public sealed record ComputedProgram : Computation
{
    /// <summary>The inputs that it is based on.</summary>
    public required CorrectionBasis Basis { get; init; }

    /// <summary>Name of the program in the job, without folders. At the machine it has the slot's program name.</summary>
    public required string ProgramName { get; init; }

    /// <summary>The bytes to send: those of the base program if there is nothing to compensate, or the program that sets offsets of the
    /// control.</summary>
    public required ReadOnlyMemory<byte> Program { get; init; }

    /// <summary>What the program sets, if it sets offsets of the control; else null.</summary>
    public Statement? Offset { get; init; }

    /// <summary>The program that takes an offset back; null if <see cref="Offset"/> is.</summary>
    public ReadOnlyMemory<byte>? Undo { get; init; }

    /// <summary>The report as JSON.</summary>
    public required ReadOnlyMemory<byte> Report { get; init; }

    /// <summary>The report as a page.</summary>
    public required ReadOnlyMemory<byte> Page { get; init; }

    /// <summary>True if the page was drawn from the report alone.</summary>
    internal bool IsPageOfReport { get; init; }

    /// <summary>The largest displacement of this step in mm, at a key point, or between or next to key points if a block must move further
    /// there.</summary>
    public required double LargestMm { get; init; }

    /// <summary>Where that is: <c>point 5 of C1</c>, <c>block N170</c>; empty if nothing moves.</summary>
    public required Statement LargestAt { get; init; }

    /// <summary>The displacement of this step at each measured point, in the job's order.</summary>
    public required IReadOnlyList<PointCorrection> Corrections { get; init; }

    /// <summary>If the job accumulates, the sums since the original program, including this step; else this step alone.</summary>
    public required CorrectionSums Sums { get; init; }

    /// <summary>If the job accumulates, the largest distance from the original program in mm: a sum at a point, or a larger distance
    /// between or next to points; else <see cref="LargestMm"/>.</summary>
    public required double SumMm { get; init; }

    /// <summary>Number of blocks that differ from the base program; null if the program is generated.</summary>
    public required int? ChangedBlocks { get; init; }

    /// <summary>Number of words that were changed or inserted; null if the program is generated.</summary>
    public required int? ChangedWords { get; init; }

    /// <summary>What a person must not overlook before approving.</summary>
    public required IReadOnlyList<Statement> Warnings { get; init; }
}

/// <summary>The displacement of the boundary or the surface at a measured point, in mm.</summary>
/// <param name="Point">The point's label in the job, or its number in the measuring plan.</param>
/// <param name="X">Along the program's X; for a mating in another plane, along that plane's first axis.</param>
/// <param name="Y">Along the program's Y, or the plane's second axis.</param>
/// <param name="Z">Along the program's Z; zero for a mating.</param>
public sealed record PointCorrection(string Point, double X, double Y, double Z)
{
    /// <summary>Its length in mm.</summary>
    public double LengthMm => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));
}
