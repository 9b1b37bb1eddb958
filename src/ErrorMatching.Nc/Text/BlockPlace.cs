namespace ErrorMatching.Nc;

/// <summary>A place in a block of a language: what may follow there.</summary>
internal enum BlockPlace : byte
{
    /// <summary>Before the block number.</summary>
    Number,

    /// <summary>Before the statement.</summary>
    Statement,

    /// <summary>Among the words after the statement.</summary>
    Words,

    /// <summary>Behind a statement that may continue in the next line.</summary>
    Continued,

    /// <summary>Among the words of a tool call, where an axis stands without a coordinate.</summary>
    Tool,

    /// <summary>Behind the word of a chamfer, whose length has no letter.</summary>
    Chamfer,
}
