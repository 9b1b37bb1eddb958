namespace ErrorMatching.Cell;

/// <summary>A program that replaced another, and the replaced one.</summary>
/// <param name="There">The bytes read back under the program's name.</param>
/// <param name="Was">The bytes that had the name until that moment, read after the replacement; null if there were none.</param>
public sealed record ReplacedProgram(byte[] There, byte[]? Was);
