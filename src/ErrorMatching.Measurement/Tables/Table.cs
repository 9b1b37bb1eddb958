using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The text of a file as a table: fields above it, an optional header line, and rows of equal width.</summary>
internal sealed class Table
{
    private readonly CsvRow? _header;
    private readonly TableLayout _layout;

    private Table(string file, IReadOnlyList<HeaderField> fields, CsvRow? header, IReadOnlyList<CsvRow> rows, TableLayout layout) =>
        (File, Fields, _header, Rows, _layout) = (file, fields, header, rows, layout);

    public string File { get; }

    public IReadOnlyList<HeaderField> Fields { get; }

    public IReadOnlyList<CsvRow> Rows { get; }

    /// <summary>Reads a table whose rows have the width of its first line.</summary>
    /// <exception cref="InputException">The text is empty, or a row has too few or too many cells.</exception>
    public static Table Read(string text, string file, TableLayout layout)
    {
        if (string.IsNullOrWhiteSpace(text))
        {
            throw Place.Start(file).Fail(MeasurementError.EmptyFile, "an empty file", "a measurement: export it again");
        }

        var start = 0;
        var fields = new List<HeaderField>();
        for (var line = 1; line <= layout.SkipLines; line++)
        {
            var end = LineBreaks.NextLine(text, start);
            AddField(fields, text[start..end].Trim(), line, layout.Delimiter);
            start = end;
        }

        List<CsvRow> rows = [.. CsvRows.Read(text[start..], file, layout.SkipLines + 1, layout.Delimiter)];
        if (rows.Count == 0)
        {
            throw Place.Start(file).Fail(
                MeasurementError.MissingHeader,
                $"nothing behind the {layout.SkipLines} lines that the format skips",
                "a table: correct skipLines in its format");
        }

        foreach (var row in rows)
        {
            CheckWidth(row, rows[0], layout.IsFixed);
        }

        return new(file, fields, layout.HasHeader ? rows[0] : null, layout.HasHeader ? rows[1..] : rows, layout);
    }

    /// <summary>The index of a required column.</summary>
    /// <exception cref="InputException">The column is missing or occurs twice.</exception>
    public int Find(ColumnSelector column) => column.Name is not { } name ? FindAt(column.Position - 1)
        : FindNamed(name, column.PrefersName && IndexesOf([name]).Count > 0 ? [name] : column.Names);

    /// <summary>The index of an optional column, or -1.</summary>
    public int FindOptional(ColumnSelector column) => column.Name is not null && IndexesOf(column.Names).Count == 0 ? -1 : Find(column);

    /// <summary>The index of the only column that has one of several names.</summary>
    public int FindNamed(string shown, IReadOnlyList<string> names)
    {
        var indexes = IndexesOf(names);
        return indexes switch
        {
            [var only] => only,
            [] => throw MissingColumn(shown),
            [_, var second, ..] => throw _header!.PlaceOf(second).Fail(
                MeasurementError.DuplicateColumn,
                $"a second column for {shown}, {MeasurementRefusal.Quote(_header.Texts[second])}",
                "each needed column once: delete or rename one"),
        };
    }

    public Cell Cell(CsvRow row, int index) =>
        new(
            row.Texts[index].Trim(),
            row.PlaceOf(index),
            _header is null ? "number " + (index + 1).ToString(CultureInfo.InvariantCulture) : _header.Texts[index].Trim(),
            _layout.DecimalComma)
        {
            IsFixed = _layout.IsFixed,
        };

    /// <summary>The location of a column's heading, or of its first cell.</summary>
    public Place Top(int index) => (_header ?? Rows[0]).PlaceOf(index);

    public IReadOnlyList<string>? TextsOf(string name)
    {
        var indexes = IndexesOf([name]);
        return indexes.Count == 0 ? null : [.. Rows.SelectMany(r => indexes.Select(i => r.Texts[i].Trim()))];
    }

    private int FindAt(int index) => index < (_header ?? Rows[0]).Texts.Count ? index : throw Top(0).Fail(
        MeasurementError.MissingColumn,
        $"{(_header ?? Rows[0]).Texts.Count} columns",
        $"a column number {index + 1}: correct the delimiter or the positions in the format");

    private List<int> IndexesOf(IReadOnlyList<string> names) => _header is null
        ? []
        : [
            .. Enumerable.Range(0, _header.Texts.Count).Where(i => names.Contains(
                _header.Texts[i].Trim(), StringComparer.OrdinalIgnoreCase))];

    private InputException MissingColumn(string name)
    {
        var cells = _header!.Texts;
        if (cells.Count > 1 && cells.Count(c => DecimalNumber.TryRead(c.Trim(), _layout.DecimalComma) is not null) * 2 > cells.Count)
        {
            return Top(0).Fail(
                MeasurementError.MissingHeader, "numbers in the first line", $"a header with the names of the columns, among them {name}");
        }

        var other = cells.Count == 1 ? ",;\t|".FirstOrDefault(d => d != _layout.Delimiter && cells[0].Contains(d)) : '\0';
        return Top(0).Fail(
            MeasurementError.MissingColumn,
            "a header with the columns " + string.Join(", ", cells.Take(20).Select(c => MeasurementRefusal.Quote(c.Trim()))),
            $"a column {name}"
                + (other == '\0' ? "" : $": set the delimiter of the format to {MeasurementRefusal.Quote(other.ToString())}"));
    }

    private static void CheckWidth(CsvRow row, CsvRow first, bool isFixed)
    {
        var (count, width) = (row.Texts.Count, first.Texts.Count);
        if (count < width)
        {
            throw row.PlaceOf(count).Fail(
                MeasurementError.ShortRow,
                $"a line of {count} cells",
                $"{width} cells as in the first line: the line is cut off, or a delimiter is missing");
        }

        for (var i = width; i < count; i++)
        {
            if (!string.IsNullOrWhiteSpace(row.Texts[i]))
            {
                throw row.PlaceOf(i).Fail(
                    MeasurementError.LongRow,
                    $"a line of {count} cells",
                    $"{width} cells as in the first line: are there decimal commas or thousands separators that split a number? "
                        + (isFixed
                            ? "Write numbers with decimal points"
                            : "A file with decimal commas needs semicolons or tabs between its cells, and \"decimalComma\": true in the "
                                + "\"format\" of \"gauge\""));
            }
        }
    }

    private static void AddField(List<HeaderField> fields, string line, int number, char delimiter)
    {
        var split = line.AsSpan().IndexOfAny(':', '=', delimiter);
        if (split > 0)
        {
            fields.Add(new(Bare(line[..split]), Bare(line[(split + 1)..].TrimEnd(delimiter)), number));
        }
    }

    private static string Bare(string text) => text.Trim().Trim('"').Trim();
}

/// <summary>The layout of a table in its text.</summary>
/// <param name="SkipLines">Lines above the table.</param>
/// <param name="Delimiter">The cell separator.</param>
/// <param name="DecimalComma">True if numbers are written 32,067 instead of 32.067.</param>
/// <param name="HasHeader">True if the first line names the columns.</param>
internal readonly record struct TableLayout(int SkipLines, char Delimiter, bool DecimalComma, bool HasHeader)
{
    /// <summary>True if no job can describe the layout, so that messages do not say how.</summary>
    public bool IsFixed { get; init; }
}

/// <summary>A name and value from the lines above the table, such as <c>Serial number: 4711</c>.</summary>
/// <param name="Name">The text before the first colon, equals sign or delimiter.</param>
/// <param name="Value">The text after it.</param>
/// <param name="Line">Line of the file, from 1.</param>
public readonly record struct HeaderField(string Name, string Value, int Line);
