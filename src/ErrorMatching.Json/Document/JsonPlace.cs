namespace ErrorMatching.Json;

/// <summary>A location in a document, counted as in an editor.</summary>
/// <param name="Line">Line, from 1.</param>
/// <param name="Column">Column in Unicode characters, from 1.</param>
public readonly record struct JsonPlace(int Line, int Column);
