namespace ErrorMatching.Nc;

/// <summary>A block that is part of a structure, linked to the structure's other statements.</summary>
/// <param name="kind">Its kind.</param>
/// <param name="block">Its position.</param>
/// <param name="at">Start of its condition or argument, from the start of the block.</param>
internal sealed class FlowStatement(FlowKind kind, int block, int at)
{
    public FlowKind Kind { get; } = kind;

    public int Block { get; } = block;

    public int At { get; } = at;

    /// <summary>The statement that begins the structure; null if there is none.</summary>
    public FlowStatement? Start { get; set; }

    /// <summary>The next branch of an IF, or its end.</summary>
    public FlowStatement? Branch { get; set; }

    /// <summary>The statement that ends the structure; set on the one that begins it.</summary>
    public FlowStatement? End { get; set; }
}

/// <summary>Structure statements over several blocks, independent of a family's names.</summary>
internal enum FlowKind : byte
{
    If,
    ElseIf,
    Else,
    EndIf,

    /// <summary>A loop with its condition at the start.</summary>
    While,
    EndWhile,

    /// <summary>A loop with its condition at the end: DO .. WHILE, REPEAT .. UNTIL.</summary>
    Do,
    Until,

    /// <summary>A loop with a number of passes.</summary>
    Repeat,
    EndRepeat,

    /// <summary>A loop over a counting variable.</summary>
    For,
    EndFor,

    /// <summary>A loop without a condition.</summary>
    Loop,
    EndLoop,

    /// <summary>The definition of a subroutine.</summary>
    Sub,
    EndSub,
    Call,
    Return,
    Break,
    Continue,
}
