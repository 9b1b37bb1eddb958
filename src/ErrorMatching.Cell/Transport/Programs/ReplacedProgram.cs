namespace ErrorMatching.Cell;

/// <summary>A program that took the place of another, and that other one.</summary>
/// <param name="There">What was read back under the program's name.</param>
/// <param name="Was">What had the name until that moment, read after it; null if nothing had.</param>
public sealed record ReplacedProgram(byte[] There, byte[]? Was);
