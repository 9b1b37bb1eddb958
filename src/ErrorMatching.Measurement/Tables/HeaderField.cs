namespace ErrorMatching.Measurement;

/// <summary>A name and value from the lines above the table, such as <c>Serial number: 4711</c>.</summary>
/// <param name="Name">The text before the first colon, equals sign or delimiter.</param>
/// <param name="Value">The text after it.</param>
/// <param name="Line">Line of the file, from 1.</param>
public readonly record struct HeaderField(string Name, string Value, int Line);
