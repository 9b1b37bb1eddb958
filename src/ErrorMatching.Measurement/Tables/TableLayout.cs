namespace ErrorMatching.Measurement;

/// <summary>The layout of a table in its text.</summary>
/// <param name="SkipLines">Lines above the table.</param>
/// <param name="Delimiter">The cell separator.</param>
/// <param name="DecimalComma">True if numbers are written 32,067 instead of 32.067.</param>
/// <param name="HasHeader">True if the first line names the columns.</param>
internal readonly record struct TableLayout(int SkipLines, char Delimiter, bool DecimalComma, bool HasHeader);
