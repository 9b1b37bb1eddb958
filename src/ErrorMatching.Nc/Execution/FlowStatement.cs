namespace ErrorMatching.Nc;

/// <summary>A block that is part of a structure, with its partners.</summary>
/// <param name="kind">What it is.</param>
/// <param name="block">Its position.</param>
/// <param name="at">Where its condition or argument begins, from the start of the block.</param>
internal sealed class FlowStatement(FlowKind kind, int block, int at)
{
    public FlowKind Kind { get; } = kind;

    public int Block { get; } = block;

    public int At { get; } = at;

    /// <summary>The statement that begins the structure; null where there is none.</summary>
    public FlowStatement? Start { get; set; }

    /// <summary>The next branch of an IF, or its end.</summary>
    public FlowStatement? Branch { get; set; }

    /// <summary>The statement that ends the structure; kept at the one that begins it.</summary>
    public FlowStatement? End { get; set; }
}
