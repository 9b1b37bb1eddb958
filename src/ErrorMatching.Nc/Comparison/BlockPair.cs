namespace ErrorMatching.Nc;

/// <summary>A row of two programs side by side.</summary>
/// <param name="Before">Position of a block in the first program; -1 where the second has a block of its own.</param>
/// <param name="After">Position of a block in the second program; -1 where the first has a block of its own.</param>
/// <param name="IsSame">True if both blocks say the same: the same words with the same values,
/// whatever their block numbers and spaces.</param>
public readonly record struct BlockPair(int Before, int After, bool IsSame);
