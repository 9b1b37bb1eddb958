namespace ErrorMatching.Measurement;

/// <summary>One record of a file: its cells, each with the line it starts in, for a quoted cell may hold line breaks.</summary>
internal sealed record CsvRow(string File, IReadOnlyList<string> Texts, IReadOnlyList<int> Lines)
{
    /// <summary>The line that the record starts in.</summary>
    public int Line => Lines[0];

    /// <summary>True if there is nothing in the record: a blank line.</summary>
    public bool IsBlank => Texts is [var only] && string.IsNullOrWhiteSpace(only);

    /// <summary>The place of a cell counted from 0; behind the last cell, the end of the record.</summary>
    public Place PlaceOf(int index) => new(File, Lines[Math.Min(index, Lines.Count - 1)], index + 1);
}
