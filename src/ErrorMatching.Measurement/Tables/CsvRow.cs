namespace ErrorMatching.Measurement;

/// <summary>One record of a file: its cells and their lines.</summary>
/// <param name="File">The file name, as given by the caller.</param>
/// <param name="Line">The line in which the record starts.</param>
/// <param name="Texts">The cells.</param>
/// <param name="Lines">The line of each cell; null if the record is on one line, as usual.</param>
internal sealed record CsvRow(string File, int Line, IReadOnlyList<string> Texts, IReadOnlyList<int>? Lines)
{
    public bool IsBlank => Texts is [var only] && string.IsNullOrWhiteSpace(only);

    /// <summary>The location of a cell by index from 0; after the last cell, the end of the record.</summary>
    public Place PlaceOf(int index) => new(File, Lines is null ? Line : Lines[Math.Min(index, Lines.Count - 1)], index + 1);
}
