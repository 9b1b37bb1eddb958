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
