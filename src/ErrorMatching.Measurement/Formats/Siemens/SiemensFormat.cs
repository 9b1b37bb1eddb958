using System.Text.RegularExpressions;

namespace ErrorMatching.Measurement;

/// <summary>The protocol of Siemens measuring cycles (CYCLE97x): a line for each measured axis. Its layout is assumed.</summary>
internal sealed class SiemensFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).Any(l => SiemensReader.IsResult(l));

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new SiemensReader(source, format).Read();
}

/// <summary>Reads the axes of a protocol. The number behind the cycle is the label of the point.</summary>
/// <remarks>
/// <code>
/// CYCLE978 1  X Soll 12.000 Ist 12.004 Diff 0.004
/// CYCLE978 1  Y Soll -10.000 Ist -10.038 Diff -0.038
/// </code>
/// One call of CYCLE978 measures one axis, so a point needs two calls with its number. Lines before the first result are text. A
/// difference must be the measured value less the nominal one.
/// </remarks>
internal sealed partial class SiemensReader(MeasurementBytes source, MeasurementFormat format)
{
    private readonly AxisPoints _points = new(SelfDescribingFormat.MaxPoints);
    private readonly DeviationCheck _deviations = new();

    /// <summary>True for a line with a result.</summary>
    public static bool IsResult(string line) => Result().IsMatch(line);

    public MeasuredContent Read()
    {
        var hasResult = false;
        foreach (var line in LogLines.Of(source, format))
        {
            var found = Result().Match(line.Text);
            if (found.Success)
            {
                Add(line, found);
                hasResult = true;
            }
            else if (hasResult || line.Text.StartsWith("CYCLE", StringComparison.Ordinal))
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    MeasurementRefusal.Quote(line.Text),
                    "CYCLE978 1 X Soll ... Ist ... Diff ...: the line is cut off, or the file is a mixture");
            }
        }

        _deviations.Run();
        return _points.Content(format.Unit, Place.Start(source.File)) with { HasNumbers = true };
    }

    private void Add(TextLine line, Match found)
    {
        var (nominal, actual) = (CellOf("nominal", 4), CellOf("actual", 5));
        _deviations.Add(nominal, actual, CellOf("difference", 6));
        _points.Add(
            CellOf("label", 2),
            actual,
            found.Groups["axis"].Value[0],
            Coordinate.Read(nominal, format.Unit),
            Coordinate.Read(actual, format.Unit));

        Cell CellOf(string name, int column) => line.Cell(found.Groups[name].Value, column, name);
    }

    [GeneratedRegex(
        "^CYCLE97[0-9] +(?<label>[0-9A-Za-z_]{1,40}) +(?<axis>[XYZ]) +Soll +(?<nominal>[-+]?[0-9.]+) +Ist +(?<actual>[-+]?[0-9.]+)"
            + " +Diff +(?<difference>[-+]?[0-9.]+)$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Result();
}
