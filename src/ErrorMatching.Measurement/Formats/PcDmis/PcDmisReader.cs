namespace ErrorMatching.Measurement;

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
