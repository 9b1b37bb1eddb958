using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Columns of decimal numbers, stored as text so that no digits are lost before a calculation.</summary>
public sealed class NumberTable
{
    private readonly IReadOnlyDictionary<string, IReadOnlyList<string>> _columns;
    private readonly IReadOnlyDictionary<string, int> _positions;

    private NumberTable(
        string file,
        IReadOnlyList<int> lines,
        IReadOnlyDictionary<string, IReadOnlyList<string>> columns,
        IReadOnlyDictionary<string, int> positions) =>
        (File, Lines, _columns, _positions) = (file, lines, columns, positions);

    /// <summary>The file name, as given by the caller.</summary>
    public string File { get; }

    /// <summary>The line of each row, from 1.</summary>
    public IReadOnlyList<int> Lines { get; }

    /// <summary>Number of rows; at least one.</summary>
    public int Count => Lines.Count;

    /// <summary>The numbers of a column in the order of the file: decimal texts with a decimal point and an optional exponent, each within
    /// double precision.</summary>
    /// <param name="name">One of the column names passed when reading.</param>
    /// <exception cref="KeyNotFoundException">The column was not read.</exception>
    public IReadOnlyList<string> this[string name] => _columns[name];

    /// <summary>The position of a column in the file, from 1, as in a spreadsheet.</summary>
    /// <param name="name">One of the column names passed when reading.</param>
    /// <exception cref="KeyNotFoundException">The column was not read.</exception>
    public int ColumnOf(string name) => _positions[name];

    /// <summary>Reads columns of a CSV file in UTF-8 with decimal points. Cells are separated by commas, or by semicolons or tabs if the
    /// header has them.</summary>
    /// <param name="path">The file, as named in errors.</param>
    /// <param name="columns">The required columns. In the header, each may end in <c>_mm</c>. Other columns are ignored.</param>
    /// <exception cref="InputException">The file cannot be opened, lacks a column or has it twice, has no rows, or a cell of a
    /// column is not a decimal number.</exception>
    public static NumberTable Read(string path, params IReadOnlyList<string> columns) =>
        Read(FileBytes.Read(path, MeasurementFormat.Points.MaxBytes), path, columns);

    /// <summary>Reads columns of a CSV file from its bytes, as in the other overload.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="fileName">The file name in errors.</param>
    /// <param name="columns">The required columns. In the header, each may end in <c>_mm</c>. Other columns are ignored.</param>
    /// <exception cref="InputException">The file lacks a column or has it twice, has no rows, or a cell of a column is not a decimal
    /// number.</exception>
    public static NumberTable Read(ReadOnlyMemory<byte> bytes, string fileName, params IReadOnlyList<string> columns)
    {
        var format = MeasurementFormat.Points with { Delimiter = DelimiterOf(bytes.Span) };
        FileBytes.ThrowIfTooLarge(fileName, bytes.Length, format.MaxBytes);
        var table = Table.Read(
            SourceText.Decode(bytes.Span, fileName, format.Encoding, format.Delimiter), fileName, format.Layout with
            {
                IsFixed = true,
            });
        var indexes = columns.Select(c => table.FindNamed(c, [c, c + "_mm"])).ToArray();
        var texts = columns.ToDictionary(c => c, _ => new List<string>(table.Rows.Count), StringComparer.Ordinal);
        foreach (var row in table.Rows)
        {
            for (var i = 0; i < indexes.Length; i++)
            {
                texts[columns[i]].Add(table.Cell(row, indexes[i]).Number().Text);
            }
        }

        return table.Rows.Count > 0
            ? new(
                fileName,
                [.. table.Rows.Select(r => r.Line)],
                texts.ToDictionary(t => t.Key, t => (IReadOnlyList<string>)t.Value, StringComparer.Ordinal),
                columns.Zip(indexes).ToDictionary(c => c.First, c => c.Second + 1, StringComparer.Ordinal))
            : throw table.Top(indexes[0]).Fail(MeasurementError.NoPoints, "a table without rows", "at least one row of numbers");
    }

    // Column names contain neither semicolons nor tabs, so either one in the header is the cell separator.
    private static char DelimiterOf(ReadOnlySpan<byte> bytes)
    {
        var end = bytes.IndexOfAny((byte)'\n', (byte)'\r');
        var header = end < 0 ? bytes : bytes[..end];
        return header.Contains((byte)';') ? ';' : header.Contains((byte)'\t') ? '\t' : ',';
    }
}
