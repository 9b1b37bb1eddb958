using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

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
