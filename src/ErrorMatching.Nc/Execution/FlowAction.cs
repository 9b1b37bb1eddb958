namespace ErrorMatching.Nc;

/// <summary>What follows when a block has been given to the machine.</summary>
internal enum FlowAction : byte
{
    /// <summary>The block has words of its own: read and act on them, then give the block to <see cref="NcFlow.Behind"/>.</summary>
    Words,

    /// <summary>The block is done: go on at <see cref="NcFlow.Next"/> of <see cref="NcFlow.Program"/>.</summary>
    Continue,

    /// <summary>The program has ended, or <see cref="NcFlow.Refusal"/> says why it cannot go on.</summary>
    Stop,
}
