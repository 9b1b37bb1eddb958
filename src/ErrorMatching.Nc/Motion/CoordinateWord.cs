namespace ErrorMatching.Nc;

/// <summary>A word of a program that states a coordinate.</summary>
/// <param name="Block">Position of its block, from 0.</param>
/// <param name="Text">The word as written.</param>
public sealed record CoordinateWord(int Block, string Text);
