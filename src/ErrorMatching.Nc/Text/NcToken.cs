namespace ErrorMatching.Nc;

/// <summary>A range of a program's bytes with what it is. Tokens follow one another without gap, so together they are the block.</summary>
/// <param name="Kind">What the range is.</param>
/// <param name="Letter">Upper-case letter of a word or comma word, else 0.</param>
/// <param name="Start">First byte, counted from the start of the program.</param>
/// <param name="Length">Number of bytes.</param>
/// <param name="ValueStart">First byte of the number of a word (its sign, if it has one).</param>
/// <param name="Number">Exact value of a word.</param>
public readonly record struct NcToken(NcTokenKind Kind, byte Letter, int Start, int Length, int ValueStart, NcNumber Number)
{
    /// <summary>First byte behind the token.</summary>
    public int End => Start + Length;

    /// <summary>Number of bytes of a word's number.</summary>
    public int ValueLength => End - ValueStart;
}
