namespace ErrorMatching.Nc;

/// <summary>What to do after a block was given to the flow.</summary>
internal enum FlowAction : byte
{
    /// <summary>The block has words of its own: read and apply them, then give the block to <see cref="NcFlow.ExecuteCalls"/>.</summary>
    Words,

    /// <summary>The block is done: continue at <see cref="NcFlow.Next"/> of <see cref="NcFlow.Program"/>.</summary>
    Continue,

    /// <summary>The program has ended, or <see cref="NcFlow.Refusal"/> says why it cannot continue.</summary>
    Stop,
}
