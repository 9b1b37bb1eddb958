using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Q-DAS AQDEF (ISO/TR 11462-5): K-fields that describe characteristics, and their values, in one file or in two.</summary>
internal sealed class AqdefFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        source.Has(".dfx") || FirstLine(head) is ['K', '0', '1', '0', '0', ' ' or '\t' or '/', ..];

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var reader = new AqdefReader(source.File, format.Encoding);
        if (source.Description is { } description)
        {
            reader.Add(description);
        }

        reader.Add(source);
        return reader.Content();
    }
}

/// <summary>Reads the fields and values of one measured piece.</summary>
/// <remarks>
/// <code>
/// K0100 2                number of characteristics
/// K1001 4711             about the part
/// K2002/1 P1.X           name of characteristic 1
/// K2101/1 32.000         its nominal value
/// K2142/1 mm             its unit
/// 32.012 DC4 0 SI 5.998  the values of one piece: characteristics are separated by SI (0F), their value and attribute by DC4 (14)
/// K0001/1 32.012         the same, one value at a time
/// </code>
/// </remarks>
internal sealed class AqdefReader(string file, string encoding)
{
    /// <summary>The separators of a line of values.</summary>
    public const char BetweenCharacteristics = '\u000f', BetweenFields = '\u0014';

    private const int MostFields = 100;

    private readonly SortedDictionary<int, Characteristic> _characteristics = [];

    // What fields with the index 0 say of all characteristics.
    private readonly Characteristic _all = new();
    private readonly List<HeaderField> _fields = [];
    private readonly UnitName _unit = new();
    private int _count;
    private TextLine? _values;

    /// <summary>Reads a file: description, values, or both.</summary>
    public void Add(MeasurementBytes source)
    {
        foreach (var line in TextLine.Of(SourceText.DecodeOwn(source.Bytes.Span, source.File, encoding, "\u000f\u0014"), source.File))
        {
            if (line.Text.AsSpan().Trim(" \t\u001a").Length == 0)
            {
                continue;
            }

            if (Field(line) is { } field)
            {
                Add(field);
            }
            else
            {
                AddValues(line);
            }
        }
    }

    /// <summary>The points: characteristics whose names end in X, Y or Z.</summary>
    public MeasuredContent Content()
    {
        var start = Place.Start(file);
        if (_characteristics.Count == 0)
        {
            throw _count == 0
                ? Undescribed(new(file, 1, ""))
                : start.Fail(MeasurementError.NoPoints, "no characteristic", "fields K2002 with the names of coordinates");
        }

        if (_values is null)
        {
            throw start.Fail(
                MeasurementError.NoPoints,
                "a description without values",
                "the values: name the file .dfx that belongs to it, or export one file .dfq");
        }

        var points = new AxisPoints(SelfDescribingFormat.MaxPoints);
        foreach (var c in _characteristics.Values)
        {
            if ((c.Name ?? c.Number) is { } name && AxisName.Split(name.Text) is var (label, axis) && c.Value is { } value && c.IsValid)
            {
                var unit = (c.Unit ?? _all.Unit) is { } unitName ? _unit.Note(unitName) : LengthUnit.Millimeter;
                points.Add(
                    name with { Text = label },
                    value,
                    axis,
                    (c.Nominal ?? _all.Nominal) is { } nominal ? Coordinate.Read(nominal, unit) : null,
                    Coordinate.Read(value, unit));
            }
        }

        return points.Content(_unit.Unit, start) with { Fields = _fields };
    }

    private void Add(KField field)
    {
        switch (field.Number)
        {
            case 1 or 2:
                AddValue(field);
                break;
            case 100:
                if (_count > 0)
                {
                    throw field.Fail(MeasurementError.SeveralMeasurements, "a second part", "one part: export its measurement alone");
                }

                _count = int.TryParse(field.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var count)
                    && count is > 0 and <= SelfDescribingFormat.MaxPoints
                    ? count
                    : throw field.Fail(
                        MeasurementError.BadStructure,
                        MeasurementRefusal.Quote(field.Value) + " in K0100",
                        $"the number of characteristics, at most {SelfDescribingFormat.MaxPoints}");
                break;
            case >= 1000 and < 2000:
                if (field.Index > 1)
                {
                    throw field.Fail(MeasurementError.SeveralMeasurements, "a second part", "one part: export its measurement alone");
                }

                _fields.Add(new(field.Name, field.Value, field.Line.Number));
                break;
            case 2001 or 2002 or 2101 or 2142:
                Describe(field.Index == 0 ? _all : Of(field.Index, field), field);
                break;
        }
    }

    private static void Describe(Characteristic characteristic, KField field)
    {
        var cell = field.Line.Cell(field.Value, 1, field.Name);
        switch (field.Number)
        {
            case 2001:
                characteristic.Number = cell;
                break;
            case 2002:
                characteristic.Name = cell;
                break;
            case 2101:
                characteristic.Nominal = cell.Text.Length == 0 ? null : cell;
                break;
            default:
                characteristic.Unit = cell.Text.Length == 0 ? null : cell;
                break;
        }
    }

    private void AddValue(KField field)
    {
        var characteristic = Of(Math.Max(field.Index, 1), field);
        if (field.Number == 2)
        {
            characteristic.IsValid = IsValid(field.Value);
            return;
        }

        if (characteristic.Value is not null || (_values is { } row && row.Text.Length > 0 && row.Text[0] != 'K'))
        {
            throw Second(field.Line);
        }

        _values = field.Line;
        characteristic.Value = field.Line.Cell(field.Value, 1, field.Name);
    }

    private void AddValues(TextLine line)
    {
        if (_count == 0)
        {
            throw Undescribed(line);
        }

        if (_values is not null)
        {
            throw Second(line);
        }

        _values = line;

        var text = line.Text.Trim(' ', '\t', '\u001a');
        var count = text.AsSpan().Count(BetweenCharacteristics) + 1;
        if (count == _count + 1 && text.EndsWith(BetweenCharacteristics))
        {
            // The last value is followed by a separator, too.
            (text, count) = (text[..^1], _count);
        }

        if (count != _count)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                $"the values of {count} characteristics",
                $"{_count}, as K0100 says: the line is cut off, or it is no line of values");
        }

        var cells = text.Split(BetweenCharacteristics);
        for (var i = 0; i < _count; i++)
        {
            var fields = cells[i].Split(BetweenFields, MostFields);
            if (fields[0].Trim().Length > 0)
            {
                var characteristic = Of(i + 1, line);
                characteristic.Value = line.Cell(fields[0], i + 1, string.Create(CultureInfo.InvariantCulture, $"{i + 1}"));
                characteristic.IsValid = fields.Length < 2 || IsValid(fields[1]);
            }
        }
    }

    // Any other attribute says that the value does not count.
    private static bool IsValid(string attribute) => attribute.Trim() is "" or "0";

    private static InputException Second(TextLine line) => line.Fail(
        MeasurementError.SeveralMeasurements, "the values of a second piece", "those of one piece: export its measurement alone");

    private InputException Undescribed(TextLine line) => file.EndsWith(".dfx", StringComparison.OrdinalIgnoreCase)
        ? line.Fail(
            MeasurementError.MissingDescription,
            "values without their description",
            "the file of the same name with .dfd in the same folder, or one file .dfq with both")
        : line.Fail(
            MeasurementError.BadStructure, MeasurementRefusal.Quote(line.Text), "K0100 with the number of characteristics first");

    private Characteristic Of(int index, KField field) => Of(index, field.Line);

    private Characteristic Of(int index, TextLine line)
    {
        if (index < 1 || index > _count)
        {
            throw _count == 0
                ? Undescribed(line)
                : line.Fail(
                    MeasurementError.BadStructure,
                    string.Create(CultureInfo.InvariantCulture, $"characteristic {index}"),
                    $"1 to {_count}, as K0100 says");
        }

        if (!_characteristics.TryGetValue(index, out var characteristic))
        {
            _characteristics.Add(index, characteristic = new());
        }

        return characteristic;
    }

    // K2002/1 P1.X. Null for any other line.
    private static KField? Field(TextLine line)
    {
        var text = line.Text.AsSpan().TrimStart();
        if (text is not ['K', _, _, _, _, ..] || !int.TryParse(text[1..5], NumberStyles.None, CultureInfo.InvariantCulture, out var number))
        {
            return null;
        }

        text = text[5..];
        var end = text.IndexOfAny(' ', '\t');
        var suffix = end < 0 ? text : text[..end];
        var index = number == 100 || number >= 3000 || suffix.IsEmpty ? 1
            : suffix[0] == '/' && int.TryParse(suffix[1..], NumberStyles.None, CultureInfo.InvariantCulture, out var read) ? read
            : throw line.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(line.Text),
                "a field such as K2002/1 with its value behind a space");
        return new(line, number, index, end < 0 ? "" : text[end..].Trim().ToString());
    }

    private sealed record KField(TextLine Line, int Number, int Index, string Value)
    {
        public string Name => string.Create(CultureInfo.InvariantCulture, $"K{Number:0000}");

        public InputException Fail(string code, string found, string expected) => Line.Fail(code, found, expected);
    }

    private sealed class Characteristic
    {
        public Cell? Number { get; set; }

        public Cell? Name { get; set; }

        public Cell? Nominal { get; set; }

        public Cell? Unit { get; set; }

        public Cell? Value { get; set; }

        public bool IsValid { get; set; } = true;
    }
}
