namespace ErrorMatching.Nc;

/// <summary>Statements that belong together over several blocks, whatever a family calls them.</summary>
internal enum FlowKind : byte
{
    If,
    ElseIf,
    Else,
    EndIf,

    /// <summary>A loop whose condition stands at its begin.</summary>
    While,
    EndWhile,

    /// <summary>A loop whose condition stands at its end: DO .. WHILE, REPEAT .. UNTIL.</summary>
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
