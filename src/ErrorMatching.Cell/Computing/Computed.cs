namespace ErrorMatching.Cell;

/// <summary>A program that may be proposed, with what people decide by. The same inputs give the same bytes.</summary>
public sealed record Computed : Computation
{
    /// <summary>What it stands on.</summary>
    public required CorrectionBasis Basis { get; init; }

    /// <summary>Name of the program in the job, without folders. At the machine it has its slot's.</summary>
    public required string ProgramName { get; init; }

    /// <summary>The bytes to send: those of the base program where nothing is to be compensated.</summary>
    public required ReadOnlyMemory<byte> Program { get; init; }

    /// <summary>The report as JSON.</summary>
    public required ReadOnlyMemory<byte> Report { get; init; }

    /// <summary>The report as a page.</summary>
    public required ReadOnlyMemory<byte> Page { get; init; }

    /// <summary>The largest displacement of this step in mm: at a key point, or between and beside them where a block is asked to move further.</summary>
    public required double LargestMm { get; init; }

    /// <summary>Where that is: <c>point 5 of C1</c>, <c>block N170</c>; empty where nothing moves.</summary>
    public required string LargestAt { get; init; }

    /// <summary>What this step moves at each measured point, in the order of the job.</summary>
    public required IReadOnlyList<PointCorrection> Corrections { get; init; }

    /// <summary>Where the job accumulates, the sums since the original program, this step included; else this step alone.</summary>
    public required CorrectionSums Sums { get; init; }

    /// <summary>Where the job accumulates, the largest distance from the original program in mm: a sum at a point, or further between and beside them; else <see cref="LargestMm"/>.</summary>
    public required double SumMm { get; init; }

    /// <summary>Number of blocks that differ from the base program; null where the program is made anew.</summary>
    public required int? ChangedBlocks { get; init; }

    /// <summary>Number of words that were changed or inserted; null where the program is made anew.</summary>
    public required int? ChangedWords { get; init; }

    /// <summary>Sentences that a person must not overlook before approving.</summary>
    public required IReadOnlyList<string> Warnings { get; init; }
}
