using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>The results file of an inspection on the machine, as posts for Fusion's Inspect Surface make the control print it: G800 with
/// the nominal point, its normal and limits, G801 with the ball's center and radius.</summary>
internal sealed class ResultsFileFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) => LogLines.OfHead(head).Any(
        l => l.StartsWith("G800 N", StringComparison.Ordinal) || l.StartsWith("G801 N", StringComparison.Ordinal));

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new ResultsFileReader(source, format).Read();
}

/// <summary>Reads the points of a results file as contacts.</summary>
/// <remarks>
/// <code>
/// START
/// G800 N1 X12. Y-10. Z-5. I0. J-1. K0. O0. U0.05 L0.05
/// G801 N1 X12. Y-13.0377 Z-5. R3.
/// END
/// </code>
/// G801 has the center of the ball. The side of the nominal point on which the balls are shows which way the normals point: they point
/// out of the piece where the balls are before them, as posts write it, so the contact is the center less the radius along the normal.
/// Where the centers are at the nominal points themselves, those are centers too, and the vectors are taken for the direction in which
/// the probe moved. All points must agree.
/// </remarks>
internal sealed class ResultsFileReader(MeasurementBytes source, MeasurementFormat format)
{
    private const string End = "END", Start = "START";
    private const double UnitLength = 1e-3;

    private static readonly string[] Texts = ["RESULTSFILE", "DOCUMENTID", "MODELVERSION", "TIMESTAMP", "TOOLPATHID", "TOOLPATH"];

    private readonly LogPoints _points = new(source.File, format.Unit);
    private readonly List<HeaderField> _fields = [];
    private Nominal? _nominal;
    private int? _side;
    private bool _hasStart;
    private bool _hasEnd;

    public MeasuredContent Read()
    {
        TextLine last = default;
        foreach (var line in LogLines.Of(source, format))
        {
            Read(line);
            last = line;
        }

        if (_hasStart && !_hasEnd)
        {
            throw last.Fail(MeasurementError.BadStructure, "no END behind START", "the line END: the file is cut off, copy it again");
        }

        ThrowIfUnmeasured(last);
        return _points.Content(isByOrder: false) with { Fields = _fields, IsContact = true };
    }

    private void Read(TextLine line)
    {
        var text = line.Text;
        if (text.StartsWith("G800", StringComparison.Ordinal))
        {
            ThrowIfUnmeasured(line);
            _nominal = Nominal.Read(Words(line), line, format.Unit);
        }
        else if (text.StartsWith("G801", StringComparison.Ordinal))
        {
            AddMeasured(line);
        }
        else if (text.StartsWith("G330", StringComparison.Ordinal))
        {
            ThrowIfTurned(line);
        }
        else if (text is Start && _hasStart)
        {
            throw line.Fail(
                MeasurementError.SeveralMeasurements, "a second START", "one measurement in a file: keep the last set of results alone");
        }
        else if (text is Start or End)
        {
            _hasStart |= text is Start;
            _hasEnd |= text is End;
        }
        else if (Array.Find(Texts, t => text.StartsWith(t, StringComparison.Ordinal)) is { } name)
        {
            _fields.Add(new(name, text[name.Length..].Trim(), line.Number));
        }
        else if (text is not ['(' or '%', ..] && !text.StartsWith("G331", StringComparison.Ordinal)
            && !text.StartsWith("G802", StringComparison.Ordinal))
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(text),
                "G800 and G801 for each point: the line is cut off, or the file is a mixture");
        }
    }

    private void AddMeasured(TextLine line)
    {
        var words = Words(line);
        var (number, center, radius) = (Cell(words, "N", line), Place(words, line), Cell(words, "R", line));
        if (_nominal is not { } nominal || nominal.Number != number.Text)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                $"G801 of point {MeasurementRefusal.Quote(number.Text)} "
                    + (_nominal is null ? "without G800" : $"behind G800 of point {MeasurementRefusal.Quote(_nominal.Number)}"),
                "G800 and G801 of the same point, one behind the other",
                number.Place.Column);
        }

        _nominal = null;
        var r = Coordinate.Read(radius, format.Unit);
        if (r < 0)
        {
            throw radius.Fail(MeasurementError.BadStructure, "the radius of the ball, zero or more");
        }

        // Half a radius to either side decides, far beyond what a piece may deviate.
        var along = (center - nominal.Place).Dot(nominal.Normal);
        var side = r == 0 ? 0 : along > r / 2 ? -1 : 1;
        var isAtCenter = Math.Abs(along) <= r / 2;
        var kind = r == 0 ? 0 : isAtCenter ? 2 : side;
        if ((_side ??= kind) != kind)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                string.Create(CultureInfo.InvariantCulture, $"point {number.Text} is {along:0.###} mm from its nominal along the normal"),
                "all balls on the same side of the nominal points, a radius away, or all at them: is a normal reversed?");
        }

        _points.Add(number, center + (nominal.Normal * (side * r)), hasZ: true, number);
    }

    private Point3 Place(List<LogWord> words, TextLine line) => Vector(words, line, format.Unit, "X", "Y", "Z");

    private void ThrowIfUnmeasured(TextLine line)
    {
        if (_nominal is { } nominal)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                $"no G801 of point {MeasurementRefusal.Quote(nominal.Number)}",
                "the measured point behind each G800: the point was not measured, or the file is cut off");
        }
    }

    private static void ThrowIfTurned(TextLine line)
    {
        if (Words(line).FirstOrDefault(w => w.Letters is "A" or "B" or "C" && w.Number.AsSpan().ContainsAnyInRange('1', '9')) is
            { Letters: not null } turned)
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                $"{turned.Letters}{turned.Number} in G330",
                "points measured without turning the work plane: their coordinates are not in the part's frame",
                turned.Position);
        }
    }

    private static List<LogWord> Words(TextLine line) =>
        LogWord.Read(line.Text) ?? throw line.Fail(
            MeasurementError.BadStructure,
            MeasurementRefusal.Quote(line.Text),
            "letters and numbers, such as G801 N1 X1.5 Y2. Z-5. R3.: the line is cut off or damaged");

    private static Cell Cell(List<LogWord> words, string letter, TextLine line)
    {
        var found = words.Where(w => w.Letters == letter).ToArray();
        return found is [var word]
            ? new(word.Number, new(line.File, line.Number, word.Position), letter, false)
            : throw line.Fail(
                MeasurementError.BadStructure,
                found.Length == 0 ? $"no {letter} in {MeasurementRefusal.Quote(line.Text)}" : $"{letter} twice",
                $"{letter} once: the line is cut off or damaged",
                found.Length == 0 ? words.Count : found[1].Position);
    }

    private static Point3 Vector(List<LogWord> words, TextLine line, LengthUnit unit, string x, string y, string z) => new(
        Coordinate.Read(Cell(words, x, line), unit),
        Coordinate.Read(Cell(words, y, line), unit),
        Coordinate.Read(Cell(words, z, line), unit));

    private sealed record Nominal(string Number, Point3 Place, Vector3 Normal)
    {
        public static Nominal Read(List<LogWord> words, TextLine line, LengthUnit unit)
        {
            var normal = Vector(words, line, LengthUnit.Millimeter, "I", "J", "K") - default(Point3);
            var length = normal.Length;
            return Math.Abs(length - 1) <= UnitLength
                ? new(Cell(words, "N", line).Text, Vector(words, line, unit, "X", "Y", "Z"), normal * (1 / length))
                : throw line.Fail(
                    MeasurementError.BadStructure,
                    string.Create(CultureInfo.InvariantCulture, $"a normal (I, J, K) of the length {length:0.####}"),
                    "a normal of the length 1");
        }
    }
}
