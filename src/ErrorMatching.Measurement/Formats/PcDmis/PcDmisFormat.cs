namespace ErrorMatching.Measurement;

/// <summary>The text report of PC-DMIS: a title for each dimension, and under it a table with the header AX, NOMINAL, ... MEAS.</summary>
internal sealed class PcDmisFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        TextLine.Of(head, source.File).Any(l => PcDmisHeader.Read(l) is not null);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new PcDmisReader(source, format.Encoding).Read();
}

/// <summary>Reads the locations in a report.</summary>
/// <remarks>
/// <code>
/// DIM LOC1= LOCATION OF POINT P1  UNITS=MM
/// AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL
/// X       32.000      0.050      0.050     32.012      0.012      0.000 ----#----
/// </code>
/// Only locations are read: the coordinates of a position are relative to its datums. A feature is a point if it has X and Y.
/// </remarks>
internal sealed class PcDmisReader(MeasurementBytes source, string encoding)
{
    private const int LongestLine = 1_000;
    private const string Location = "LOCATION OF ", Units = "UNITS=";

    private static readonly string[] Parts = ["PART NAME", "PART NUMBER", "SER NUMBER", "SERIAL NUMBER", "REV NUMBER"];

    private readonly AxisPoints _points = new(SelfDescribingFormat.MaxPoints);
    private readonly DeviationCheck _deviations = new();
    private readonly UnitName _unit = new();
    private readonly List<HeaderField> _fields = [];
    private PcDmisHeader? _header;
    private Cell? _label;
    private LengthUnit _unitHere;

    public MeasuredContent Read()
    {
        TextLine title = default;
        foreach (var line in TextLine.Of(SourceText.DecodeOwn(source.Bytes.Span, source.File, encoding), source.File))
        {
            if (line.Text.Length > LongestLine)
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    $"a line of more than {LongestLine} characters",
                    "a report of PC-DMIS: is this the right file?");
            }

            var text = line.Text.Trim();
            if (PcDmisHeader.Read(line) is { } header)
            {
                _header = header;
                ReadTitle(title);
            }
            else if (text is ['X' or 'Y' or 'Z', ' ' or '\t', ..] && _header is not null)
            {
                AddRow(line, text[0]);
            }
            else if (text.Length > 0)
            {
                NotePart(line, text);
                title = line;
            }
        }

        _deviations.Run();
        return _points.Content(_unit.Unit, Place.Start(source.File)) with { Fields = _fields };
    }

    private void ReadTitle(TextLine title)
    {
        _label = null;
        var at = title.Text?.IndexOf(Location, StringComparison.OrdinalIgnoreCase) ?? -1;
        if (at < 0)
        {
            return;
        }

        var rest = title.Text![(at + Location.Length)..];
        var units = rest.IndexOf(Units, StringComparison.OrdinalIgnoreCase);
        var words = (units < 0 ? rest : rest[..units]).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        _unitHere = units < 0 ? _unit.Unit : _unit.Note(title.Cell(rest[(units + Units.Length)..].Trim().Split(' ')[0], 1, "UNITS"));
        _label = words.Length > 1
            ? title.Cell(words[^1], 1, "feature")
            : throw title.Fail(
                MeasurementError.BadStructure, MeasurementRefusal.Quote(title.Text), "the feature's kind and name behind LOCATION OF");
    }

    private void AddRow(TextLine row, char axis)
    {
        if (_label is not { } label)
        {
            return;
        }

        var measured = _header!.Value(row, "MEAS")
            ?? throw row.Fail(
                MeasurementError.ShortRow, MeasurementRefusal.Quote(row.Text), "a value under MEAS: the line is cut off or moved");
        var nominal = _header.Value(row, "NOMINAL");
        if (nominal is { } n && _header.Value(row, "DEV") is { } deviation)
        {
            _deviations.Add(n, measured, deviation);
        }

        _points.Add(
            label,
            measured,
            axis,
            nominal is { } given ? Coordinate.Read(given, _unitHere) : null,
            Coordinate.Read(measured, _unitHere));
    }

    private void NotePart(TextLine line, string text)
    {
        var split = text.IndexOfAny([':', '=']);
        if (split > 0 && Parts.Contains(text[..split].Trim(), StringComparer.OrdinalIgnoreCase))
        {
            _fields.Add(new(text[..split].Trim(), text[(split + 1)..].Trim(), line.Number));
        }
    }
}

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
