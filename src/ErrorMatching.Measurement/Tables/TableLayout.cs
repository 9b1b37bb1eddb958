namespace ErrorMatching.Measurement;

/// <summary>How a table is laid out in its text.</summary>
/// <param name="SkipLines">Lines above the table.</param>
/// <param name="Delimiter">What separates two cells.</param>
/// <param name="DecimalComma">True if numbers are written 32,067 and not 32.067.</param>
/// <param name="HasHeader">True if the first line names the columns.</param>
internal readonly record struct TableLayout(int SkipLines, char Delimiter, bool DecimalComma, bool HasHeader);
