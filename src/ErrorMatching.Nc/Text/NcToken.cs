namespace ErrorMatching.Nc;

/// <summary>A range of a program's bytes and its kind. Tokens follow one another without gaps, so together they are the block.</summary>
/// <param name="Kind">Kind of the range.</param>
/// <param name="Letter">Upper-case letter of a word or comma word, or the code of a multi-letter address (<see cref="NcAddress"/>);
/// otherwise 0.</param>
/// <param name="Start">First byte, from the start of the program.</param>
/// <param name="Length">Number of bytes.</param>
/// <param name="ValueStart">First byte of the value of a word (the sign of its number, if it has one).</param>
/// <param name="ValueLength">Number of bytes of a word's value.</param>
/// <param name="Number">Exact value of a word.</param>
/// <param name="Distance">Whether the word itself marks its value as a position or an increment.</param>
public readonly record struct NcToken(
    NcTokenKind Kind, byte Letter, int Start, int Length, int ValueStart, int ValueLength, NcNumber Number, WordDistance Distance)
{
    /// <summary>First byte after the token.</summary>
    public int End => Start + Length;
}

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

/// <summary>Whether a word itself marks its value as a position or an increment.</summary>
public enum WordDistance : byte
{
    /// <summary>Neither: the modal G90 or G91 decides.</summary>
    Modal,

    /// <summary>A position: <c>X=AC(10)</c>.</summary>
    Absolute,

    /// <summary>An increment: <c>X=IC(10)</c>.</summary>
    Incremental,
}
