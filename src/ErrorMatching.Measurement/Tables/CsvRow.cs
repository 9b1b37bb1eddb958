namespace ErrorMatching.Measurement;

/// <summary>One record of a file: its cells, and the lines they start in.</summary>
/// <param name="File">The file as the caller named it.</param>
/// <param name="Line">The line that the record starts in.</param>
/// <param name="Texts">The cells.</param>
/// <param name="Lines">The line of each cell; null if the record has one line, as nearly all have.</param>
internal sealed record CsvRow(string File, int Line, IReadOnlyList<string> Texts, IReadOnlyList<int>? Lines)
{
    /// <summary>True if there is nothing in the record: a blank line.</summary>
    public bool IsBlank => Texts is [var only] && string.IsNullOrWhiteSpace(only);

    /// <summary>The place of a cell counted from 0; behind the last cell, the end of the record.</summary>
    public Place PlaceOf(int index) => new(File, Lines is null ? Line : Lines[Math.Min(index, Lines.Count - 1)], index + 1);
}
