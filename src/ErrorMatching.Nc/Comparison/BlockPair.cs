namespace ErrorMatching.Nc;

/// <summary>A row of two programs shown side by side.</summary>
/// <param name="Before">Position of a block in the first program; -1 if only the second has a block here.</param>
/// <param name="After">Position of a block in the second program; -1 if only the first has a block here.</param>
/// <param name="IsSame">True if both blocks have the same words with the same values, regardless of block numbers and spaces.</param>
public readonly record struct BlockPair(int Before, int After, bool IsSame);
