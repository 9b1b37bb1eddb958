namespace ErrorMatching.Nc;

/// <summary>Where a variable is kept.</summary>
/// <param name="Level">The level of calls, 0 for the innermost; -1 for common variables, -2 for what was assumed of one and is
/// replaced.</param>
/// <param name="Name">Its name, or that of its array; null if it has a number only.</param>
/// <param name="Number">Its number, or its place in the array.</param>
internal readonly record struct VariableKey(int Level, string? Name, int Number);
