namespace ErrorMatching.Nc;

/// <summary>One line of a program: the position of its bytes, with and without its line end.</summary>
/// <param name="Index">Position in the program, from 0.</param>
/// <param name="Start">First byte.</param>
/// <param name="Length">Number of bytes without the line end.</param>
/// <param name="FullLength">Number of bytes with the line end; equal to <paramref name="Length"/> if the last line has none.</param>
public readonly record struct NcBlock(int Index, int Start, int Length, int FullLength)
{
    /// <summary>Line number as an editor shows it, from 1.</summary>
    public int Line => Index + 1;

    /// <summary>First byte after the text.</summary>
    public int End => Start + Length;
}
