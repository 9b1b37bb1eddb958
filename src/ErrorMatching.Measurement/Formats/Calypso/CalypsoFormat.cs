namespace ErrorMatching.Measurement;

/// <summary>The table of characteristics that ZEISS CALYPSO exports (<c>..._chr.txt</c>).</summary>
internal sealed class CalypsoFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head)
    {
        var line = FirstLine(head);
        return line.StartsWith("planid\t", StringComparison.OrdinalIgnoreCase)
            && line.Contains("\tactual\t", StringComparison.OrdinalIgnoreCase);
    }

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new CalypsoReader(source, format.Encoding).Read();
}

/// <summary>Reads the coordinates of a table of characteristics.</summary>
/// <remarks>The table has a header and tabs between its cells. A characteristic whose type is <c>xValue</c>, <c>yValue</c> or
/// <c>zValue</c> is a coordinate of its feature. The last line may be <c>END</c>. Trailing cells may be missing.</remarks>
internal sealed class CalypsoReader(MeasurementBytes source, string encoding)
{
    private const string End = "END";
    private const int MostColumns = 1_000;

    private readonly Dictionary<string, int> _columns = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<string[]> _rows = [];
    private readonly AxisPoints _points = new(SelfDescribingFormat.MaxPoints);
    private readonly DeviationCheck _deviations = new();
    private readonly UnitName _unit = new();
    private readonly List<HeaderField> _fields = [];
    private int _actual;
    private bool _hasEnded;

    public MeasuredContent Read()
    {
        foreach (var line in TextLine.Of(SourceText.DecodeOwn(source.Bytes.Span, source.File, encoding), source.File))
        {
            if (line.Text.AsSpan().Trim().IsEmpty)
            {
                continue;
            }

            if (line.Text.AsSpan().Count('\t') >= MostColumns)
            {
                throw line.Fail(
                    MeasurementError.TooManyCells,
                    $"a line of more than {MostColumns} cells",
                    "a table of CALYPSO: is this the right file?");
            }

            if (_hasEnded)
            {
                throw line.Fail(
                    MeasurementError.SeveralMeasurements, "lines behind END", "one measurement: export that of one piece alone");
            }

            if (_columns.Count == 0)
            {
                ReadHeader(line);
            }
            else if (line.Text.Trim() == End)
            {
                _hasEnded = true;
            }
            else
            {
                Add(line, line.Text.Split('\t'));
            }
        }

        _deviations.Run();
        return _points.Content(_unit.Unit, Place.Start(source.File)) with
        {
            Fields = _fields,
            Texts = name => _columns.TryGetValue(name, out var at) ? [.. _rows.Select(r => at < r.Length ? r[at].Trim() : "")] : null,
        };
    }

    private void ReadHeader(TextLine line)
    {
        var names = line.Text.Split('\t');
        for (var i = 0; i < names.Length; i++)
        {
            _columns.TryAdd(names[i].Trim(), i);
        }

        _actual = _columns.TryGetValue("actual", out var actual) && _columns.ContainsKey("id")
            ? actual
            : throw line.Fail(
                MeasurementError.MissingColumn, "a header without the columns id and actual", "both: export the table again");
    }

    private void Add(TextLine line, string[] cells)
    {
        if (cells.Length <= _actual)
        {
            throw line.Fail(
                MeasurementError.ShortRow,
                $"a line of {cells.Length} cells",
                $"at least {_actual + 1}, up to the column actual: the line is cut off",
                cells.Length);
        }

        _rows.Add(cells);
        NotePart(line, cells);
        var axis = AxisOf(Text(cells, "type")) ?? AxisOf(Text(cells, "idsymbol"));
        if (axis is not { } letter || Label(line, cells) is not { } label)
        {
            return;
        }

        var unit = Text(cells, "unit") is { Length: > 0 } name
            ? _unit.Note(line.Cell(name, _columns["unit"] + 1, "unit"))
            : LengthUnit.Millimeter;
        var actual = line.Cell(cells[_actual], _actual + 1, "actual");
        var nominal = Number(line, cells, "nominal");
        if (nominal is { } n && Number(line, cells, "deviation") is { } deviation)
        {
            _deviations.Add(n, actual, deviation);
        }

        _points.Add(
            label, actual, letter, nominal is { } given ? Coordinate.Read(given, unit) : null, Coordinate.Read(actual, unit));
    }

    // The part is the same in all lines.
    private void NotePart(TextLine line, string[] cells)
    {
        foreach (var name in (string[])["planid", "partnb"])
        {
            var text = Text(cells, name);
            if (_rows.Count == 1)
            {
                _fields.Add(new(name, text, line.Number));
            }
            else if (text != Text(_rows[0], name))
            {
                throw line.Fail(
                    MeasurementError.SeveralMeasurements,
                    $"{name} {MeasurementRefusal.Quote(text)} behind {MeasurementRefusal.Quote(Text(_rows[0], name))}",
                    "one measurement: export that of one piece alone",
                    _columns.GetValueOrDefault(name) + 1);
            }
        }
    }

    private static char? AxisOf(string type) => type.ToUpperInvariant() switch
    {
        "XVALUE" => 'X',
        "YVALUE" => 'Y',
        "ZVALUE" => 'Z',
        _ => null,
    };

    // The feature, or the characteristic's name without its axis. A characteristic that names neither is no coordinate of a point.
    private Cell? Label(TextLine line, string[] cells)
    {
        var (feature, id) = (Text(cells, "featureid"), Text(cells, "id"));
        return feature.Length > 0 ? line.Cell(feature, _columns["featureid"] + 1, "featureid")
            : AxisName.Split(id) is var (label, _) ? line.Cell(label, _columns["id"] + 1, "id")
            : null;
    }

    private Cell? Number(TextLine line, string[] cells, string name) =>
        Text(cells, name) is { Length: > 0 } text ? line.Cell(text, _columns[name] + 1, name) : null;

    private string Text(string[] cells, string name) =>
        _columns.TryGetValue(name, out var at) && at < cells.Length ? cells[at].Trim() : "";
}
