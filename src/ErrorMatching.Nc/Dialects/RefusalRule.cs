namespace ErrorMatching.Nc;

/// <summary>Something that a control refuses in a block, as its dialect states it: every condition that it has must hold.</summary>
/// <remarks>Sets of codes are bits of a <see cref="RefusalTable"/>, sets of letters have A as bit 0.</remarks>
/// <param name="Name">Its name in the dialect's file.</param>
/// <param name="Statement">The fact, in a sentence for a setter.</param>
/// <param name="IsAssumed">True if nobody has looked it up: then a note says that the control may refuse the block.</param>
internal sealed record RefusalRule(string Name, string Statement, bool IsAssumed)
{
    /// <summary>The block has one code of each set, or continues it.</summary>
    public UInt128[] Codes { get; init; } = [];

    /// <summary>The block has none of these codes, and continues none.</summary>
    public UInt128 Unless { get; init; }

    /// <summary>One code of each set is in force when the block's own codes apply.</summary>
    public ulong[] While { get; init; } = [];

    /// <summary>None of these is in force then, but something else of their group.</summary>
    public ulong WhileNot { get; init; }

    /// <summary>One of these was in force before the block.</summary>
    public ulong Before { get; init; }

    /// <summary>The code of the block was not in force before.</summary>
    public bool Begins { get; init; }

    /// <summary>The block has one letter of each set.</summary>
    public uint[] Letters { get; init; } = [];

    /// <summary>The block has none of these letters.</summary>
    public uint Missing { get; init; }

    /// <summary>One of these letters is twice in the block; an N also if another word is before it.</summary>
    public uint Repeated { get; init; }

    /// <summary>None of these bits of remembered letters is set (<see cref="RefusalTable.Remembered"/>).</summary>
    public ulong Ungiven { get; init; }

    /// <summary>The block has one of these words.</summary>
    public (byte Letter, double Value)[] Where { get; init; } = [];

    /// <summary>One of the letters has another value than these; null if values do not matter.</summary>
    public RefusalValues? Values { get; init; }

    /// <summary>The block has more M functions than this.</summary>
    public int MostFunctions { get; init; } = int.MaxValue;

    /// <summary>True if what the block does is clear all the same, such as a move without a feed.</summary>
    public bool IsClear { get; init; }
}

/// <summary>The values that a control accepts.</summary>
/// <param name="Whole">Whole numbers only.</param>
/// <param name="Least">The least one.</param>
/// <param name="Above">All must be greater than this.</param>
/// <param name="Most">The greatest one.</param>
/// <param name="OneOf">Only these; empty for all.</param>
internal sealed record RefusalValues(bool Whole, double Least, double Above, double Most, double[] OneOf)
{
    // LinuxCNC accepts this much beside a whole number, other controls less.
    private const double NearWhole = 1e-4;

    public bool Accept(double value) => value >= Least && value > Above && value <= Most
        && (!Whole || Math.Abs(value - Math.Round(value)) <= NearWhole)
        && (OneOf.Length == 0 || Array.Exists(OneOf, v => Math.Abs(v - value) <= NearWhole));
}
