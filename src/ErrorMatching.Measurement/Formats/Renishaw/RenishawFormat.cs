using System.Text.RegularExpressions;

namespace ErrorMatching.Measurement;

/// <summary>The print-out of Renishaw's probing cycles: a head with the numbers of component and feature, and under it a line for each
/// result.</summary>
internal sealed class RenishawFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).Any(l => RenishawReader.HeadOf(l) is not null);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new RenishawReader(source, format).Read();
}

/// <summary>Reads the positions of a print-out. The number of the feature is the label of its point.</summary>
/// <remarks>
/// <code>
/// COMPONENT NO 1     FEATURE NO 2
/// POSN X-12.0000 ACTUAL -12.0000 TOL 0.0500 DEV 0.0000
/// POSN Y-10.0000 ACTUAL -10.0503 TOL 0.0500 DEV -0.0503
/// </code>
/// Sizes and angles are no points. A deviation must be the measured value less the nominal one.
/// </remarks>
internal sealed partial class RenishawReader(MeasurementBytes source, MeasurementFormat format)
{
    private readonly AxisPoints _points = new(SelfDescribingFormat.MaxPoints);
    private readonly DeviationCheck _deviations = new();
    private readonly List<HeaderField> _fields = [];
    private string? _component;
    private Cell? _label;

    /// <summary>The numbers of component and feature in a line; null if it is another line.</summary>
    public static (string Component, string Feature)? HeadOf(string line) =>
        Head().Match(line) is { Success: true } found ? (found.Groups["component"].Value, found.Groups["feature"].Value) : null;

    public MeasuredContent Read()
    {
        foreach (var line in LogLines.Of(source, format))
        {
            if (HeadOf(line.Text) is var (component, feature))
            {
                Begin(line, component, feature);
            }
            else if (line.Text.StartsWith("POSN", StringComparison.Ordinal))
            {
                Add(line);
            }
            else if (!IsOther(line.Text))
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    MeasurementRefusal.Quote(line.Text),
                    "a line of Renishaw's print-out (COMPONENT NO, SIZE, POSN, ANG): the line is cut off, or the file is a mixture");
            }
        }

        _deviations.Run();
        return _points.Content(format.Unit, Place.Start(source.File)) with { Fields = _fields, HasNumbers = true };
    }

    private void Begin(TextLine line, string component, string feature)
    {
        if (_component is null)
        {
            _fields.Add(new("COMPONENT NO", component, line.Number));
        }
        else if (_component != component)
        {
            throw line.Fail(
                MeasurementError.SeveralMeasurements,
                $"component {component} behind component {_component}",
                "one measurement in a file: keep the print-out of one piece alone");
        }

        (_component, _label) = (component, line.Cell(feature, 2, "FEATURE NO"));
    }

    private void Add(TextLine line)
    {
        var found = Position().Match(line.Text);
        if (!found.Success || _label is not { } label)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(line.Text),
                _label is null
                    ? "COMPONENT NO and FEATURE NO before the first result"
                    : "POSN X... ACTUAL ... TOL ... DEV ...: the line is cut off or damaged");
        }

        var (nominal, actual, deviation) = (CellOf("nominal", 2), CellOf("actual", 3), CellOf("dev", 5));
        _deviations.Add(nominal, actual, deviation);
        _points.Add(
            label, actual, found.Groups["axis"].Value[0], Coordinate.Read(nominal, format.Unit), Coordinate.Read(actual, format.Unit));

        Cell CellOf(string name, int column) => line.Cell(
            found.Groups[name].Value.Replace(" ", "", StringComparison.Ordinal), column, name.ToUpperInvariant());
    }

    // Rules, results that are no points, and what is said about them.
    private static bool IsOther(string line) =>
        line[0] is '-' or '+' or '*' or '=' or '%' or '('
        || line.StartsWith("SIZE", StringComparison.Ordinal)
        || line.StartsWith("ANG", StringComparison.Ordinal)
        || line.StartsWith("OUT OF", StringComparison.Ordinal)
        || line.StartsWith("ERROR", StringComparison.Ordinal);

    [GeneratedRegex(
        "^COMPONENT NO[. ]{0,3}(?<component>[0-9]{1,9}) +FEATURE NO[. ]{0,3}(?<feature>[0-9]{1,9})$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Head();

    [GeneratedRegex(
        "^POSN (?<axis>[XYZ]) *(?<nominal>[-+]? *[0-9.]+) +ACTUAL +(?<actual>[-+]? *[0-9.]+)"
            + " +TOL( TP)? +[0-9.]+ +DEV +(?<dev>[-+]? *[0-9.]+)$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Position();
}
