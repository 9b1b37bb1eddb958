namespace ErrorMatching.Measurement;

/// <summary>A name and its value from the lines above the table, such as <c>Serial number: 4711</c>.</summary>
/// <param name="Name">What stands before the first colon, equals sign or delimiter.</param>
/// <param name="Value">What stands behind it.</param>
/// <param name="Line">Line of the file, counted from 1.</param>
public readonly record struct HeaderField(string Name, string Value, int Line);
