namespace ErrorMatching.Mating;

/// <summary>A range of a text.</summary>
/// <param name="Start">Index of its first character, from 0.</param>
/// <param name="Length">Number of characters.</param>
public readonly record struct TextSpan(int Start, int Length);
