namespace ErrorMatching.Json;

/// <summary>A place in the text of a document, as an editor counts it.</summary>
/// <param name="Line">Line, from 1.</param>
/// <param name="Column">Column in Unicode characters, from 1.</param>
public readonly record struct JsonPlace(int Line, int Column);
