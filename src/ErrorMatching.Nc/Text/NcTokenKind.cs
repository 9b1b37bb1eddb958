namespace ErrorMatching.Nc;

/// <summary>Kind of a range of a block, as far as spelling shows. The dialect determines its meaning.</summary>
public enum NcTokenKind : byte
{
    /// <summary>Spaces and tabs.</summary>
    Space,

    /// <summary>A letter with a plain number: <c>X-34.965</c>, <c>N100</c>, <c>G01</c>.</summary>
    Word,

    /// <summary>A letter whose value the control computes: <c>X#100</c>, <c>Y[#1+2]</c>, <c>X=R1+5</c>.</summary>
    ExpressionWord,

    /// <summary>A comma word: <c>,R5.</c> or <c>,C2.</c> (corner rounding and chamfer).</summary>
    CommaWord,

    /// <summary>A polar coordinate of LinuxCNC: <c>@5.</c> is a distance from the origin, <c>^30</c> an angle in degrees.</summary>
    PolarWord,

    /// <summary>An assignment to a variable: <c>#100=5.</c></summary>
    Assignment,

    /// <summary>A word of several letters with its arguments or value: <c>GOTO</c>, <c>IF</c>, <c>CYCLE81(...)</c>,
    /// <c>CR=5.</c></summary>
    Keyword,

    /// <summary>A separate expression in brackets.</summary>
    Expression,

    /// <summary>A comment with its delimiters.</summary>
    Comment,

    /// <summary>A percent sign and the rest of its line.</summary>
    Percent,

    /// <summary>A slash, with its level if it has one.</summary>
    BlockSkip,

    /// <summary>The name of a block or of a program at its beginning, without a value: <c>NLAP</c>, <c>OPART</c> (Okuma).</summary>
    Label,

    /// <summary>Bytes that no rule explains. They are kept like all others.</summary>
    Invalid,
}
