namespace ErrorMatching.Nc;

/// <summary>A range of a program's bytes with what it is. Tokens follow one another without gap, so together they are the block.</summary>
/// <param name="Kind">What the range is.</param>
/// <param name="Letter">Upper-case letter of a word or comma word, the code of an address of several letters (<see cref="NcAddress"/>),
/// else 0.</param>
/// <param name="Start">First byte, counted from the start of the program.</param>
/// <param name="Length">Number of bytes.</param>
/// <param name="ValueStart">First byte of the value of a word (the sign of its number, if it has one).</param>
/// <param name="ValueLength">Number of bytes of a word's value.</param>
/// <param name="Number">Exact value of a word.</param>
/// <param name="Distance">Whether the word itself says that its value is a position or an increment.</param>
public readonly record struct NcToken(
    NcTokenKind Kind, byte Letter, int Start, int Length, int ValueStart, int ValueLength, NcNumber Number, WordDistance Distance)
{
    /// <summary>First byte behind the token.</summary>
    public int End => Start + Length;
}
