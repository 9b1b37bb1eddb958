namespace ErrorMatching.Measurement;

/// <summary>The header of a table in the report: columns by name, with the position at which their right-aligned values end.</summary>
internal sealed class PcDmisHeader
{
    // A value ends within this distance of its column's end, or the row belongs to no table.
    private const int Misaligned = 5;

    private readonly (string Name, int End)[] _columns;

    private PcDmisHeader((string Name, int End)[] columns) => _columns = columns;

    /// <summary>The header in a line; null if it is another line.</summary>
    public static PcDmisHeader? Read(TextLine line)
    {
        if (!line.Text.AsSpan().TrimStart().StartsWith("AX", StringComparison.Ordinal))
        {
            return null;
        }

        var words = Words(line.Text);
        return words[0].Text == "AX" && words.Any(w => w.Text == "MEAS") && words.Any(w => w.Text == "NOMINAL")
            ? new([.. words.Skip(1).Select(w => (w.Text, w.End))])
            : null;
    }

    /// <summary>The value of a column in a row; null if the row has none.</summary>
    public Cell? Value(TextLine row, string name)
    {
        var column = Array.FindIndex(_columns, c => c.Name == name);
        if (column < 0)
        {
            return null;
        }

        // A row with all values needs no alignment, so tabs do not matter. A picture of the deviation may follow.
        var values = Words(row.Text).Skip(1).Where(w => row.Cell(w.Text, 1, name) is var cell
            && DecimalNumber.TryRead(cell.Text, cell.DecimalComma) is not null).ToArray();
        if (values.Length == _columns.Length)
        {
            return row.Cell(values[column].Text, column + 2, name);
        }

        var found = values.FirstOrDefault(v => Nearest(v.End) == column);
        return found.Text is null ? null : row.Cell(found.Text, column + 2, name);
    }

    private int Nearest(int end)
    {
        var best = Enumerable.Range(0, _columns.Length).MinBy(i => Math.Abs(_columns[i].End - end));
        return Math.Abs(_columns[best].End - end) <= Misaligned ? best : -1;
    }

    private static List<(string Text, int End)> Words(string text)
    {
        var words = new List<(string, int)>();
        for (var i = 0; i < text.Length;)
        {
            var start = i;
            while (i < text.Length && !char.IsWhiteSpace(text[i]))
            {
                i++;
            }

            if (i > start)
            {
                words.Add((text[start..i], i));
            }
            else
            {
                i++;
            }
        }

        return words;
    }
}
