namespace ErrorMatching.Nc;

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
