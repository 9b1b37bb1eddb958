using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>DMIS output (ISO 22093): the actual features of a measuring program.</summary>
internal sealed class DmisFormat : SelfDescribingFormat
{
    private static readonly string[] FirstWords = ["DMISMN/", "DMISMD/", "FILNAM/"];

    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head)
    {
        var first = TextLine.Of(head, source.File).Select(l => l.Text.Trim())
            .FirstOrDefault(l => l.Length > 0 && !l.StartsWith("$$", StringComparison.Ordinal));
        return first is not null && FirstWords.Any(w => first.StartsWith(w, StringComparison.OrdinalIgnoreCase));
    }

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new DmisReader(source, format.Encoding).Read();
}

/// <summary>Reads the actual points of a DMIS output file.</summary>
/// <remarks>
/// <code>
/// UNITS/MM,ANGDEC
/// F(P1)=FEAT/POINT,CART,32.0,6.0,0.0,0,0,1          nominal
/// FA(P1)=FEAT/POINT,CART,32.012,5.998,0.001,$       actual; a dollar sign continues a statement
///   0,0,1
/// </code>
/// </remarks>
internal sealed class DmisReader(MeasurementBytes source, string encoding)
{
    private const int LongestStatement = 65_536;

    private readonly UnitName _unit = new();
    private readonly List<HeaderField> _fields = [];
    private readonly List<(Cell Label, Cell[] Numbers)> _actuals = [];
    private readonly Dictionary<string, Cell[]> _nominals = new(StringComparer.Ordinal);

    public MeasuredContent Read()
    {
        foreach (var statement in Statements())
        {
            Read(statement);
        }

        var points = new List<LabelledPoint>();
        var nominals = new List<LabelledPoint>();
        var byLabel = new Dictionary<string, LabelledPoint>(StringComparer.Ordinal);
        foreach (var (label, numbers) in _actuals)
        {
            var point = new LabelledPoint(label.Text, Position(numbers), true, label.Place.Line);
            if (byLabel.TryGetValue(label.Text, out var earlier))
            {
                // Each tolerance of a feature is output with the feature.
                if (earlier.Position != point.Position)
                {
                    throw label.Fail(MeasurementError.DuplicatePoint, $"each point once: line {earlier.Line} has other coordinates of it");
                }

                continue;
            }

            Coordinate.ThrowIfTooMany(points.Count + 1, label, SelfDescribingFormat.MaxPoints);
            byLabel.Add(label.Text, point);
            points.Add(point);
            if (_nominals.TryGetValue(label.Text, out var nominal))
            {
                nominals.Add(point with { Position = Position(nominal) });
            }
        }

        var start = Place.Start(source.File);
        return points.Count > 0
            ? new(_unit.Unit, points, nominals.Count == points.Count ? nominals : [], start) { Fields = _fields }
            : throw start.Fail(
                MeasurementError.NoPoints,
                "no actual point, as in a measuring program",
                "the output of the program, with lines such as FA(P1)=FEAT/POINT,CART,... for each point");
    }

    private void Read(TextLine statement)
    {
        var text = statement.Text;
        if (text.StartsWith("UNITS/", StringComparison.OrdinalIgnoreCase))
        {
            _unit.Note(statement.Cell(text["UNITS/".Length..].Split(',')[0], 1, "UNITS"));
            return;
        }

        if (text.StartsWith("FILNAM/", StringComparison.OrdinalIgnoreCase))
        {
            _fields.Add(new("FILNAM", Unquoted(text["FILNAM/".Length..]), statement.Number));
            return;
        }

        var (open, close, equal) = (text.IndexOf('('), text.IndexOf(')'), text.IndexOf('='));
        if (open < 1 || close < open || equal < close)
        {
            return;
        }

        var (word, label, rest) = (
            text[..open].Trim().ToUpperInvariant(), text[(open + 1)..close].Trim(), text[(equal + 1)..].Trim());
        if (word is "F" or "FA" && rest.StartsWith("FEAT/POINT", StringComparison.OrdinalIgnoreCase))
        {
            AddPoint(statement, isActual: word == "FA", label, rest.Split(','));
        }
        else if (word is "PN" or "PS" or "PR" or "LI" && rest.IndexOf('/') is > 0 and var slash)
        {
            _fields.Add(new(rest[..slash].ToUpperInvariant(), Unquoted(rest[(slash + 1)..]), statement.Number));
        }
    }

    private void AddPoint(TextLine statement, bool isActual, string label, string[] cells)
    {
        var isCartesian = cells.Length >= 5 && string.Equals(cells[1].Trim(), "CART", StringComparison.OrdinalIgnoreCase);
        if (isCartesian && label.Length > 0)
        {
            var numbers = Enumerable.Range(2, 3).Select(i => statement.Cell(cells[i], i + 1, "XYZ"[i - 2].ToString())).ToArray();
            if (isActual)
            {
                _actuals.Add((statement.Cell(label, 1, "FA"), numbers));
            }
            else
            {
                _nominals[label] = numbers;
            }
        }
        else if (isActual)
        {
            throw statement.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(statement.Text),
                "a point with Cartesian coordinates: FA(P1)=FEAT/POINT,CART,x,y,z,i,j,k");
        }
    }

    private Point3 Position(Cell[] numbers) => new(
        Coordinate.Read(numbers[0], _unit.Unit), Coordinate.Read(numbers[1], _unit.Unit), Coordinate.Read(numbers[2], _unit.Unit));

    // Two dollar signs begin a comment, one at the end of a line continues the statement.
    private IEnumerable<TextLine> Statements()
    {
        var (joined, first) = (new StringBuilder(), 0);
        foreach (var line in TextLine.Of(SourceText.DecodeOwn(source.Bytes.Span, source.File, encoding), source.File))
        {
            var comment = line.Text.IndexOf("$$", StringComparison.Ordinal);
            var text = (comment < 0 ? line.Text : line.Text[..comment]).Trim();
            first = joined.Length == 0 ? line.Number : first;
            joined.Append(text);
            if (joined.Length > LongestStatement)
            {
                throw line.Fail(
                    MeasurementError.BadStructure, $"a statement of more than {LongestStatement} characters", "a shorter one");
            }

            if (text.EndsWith('$'))
            {
                joined.Length--;
                continue;
            }

            if (joined.Length > 0)
            {
                yield return new(line.File, first, joined.ToString());
                joined.Clear();
            }
        }

        if (joined.Length > 0)
        {
            throw new TextLine(source.File, first, "").Fail(
                MeasurementError.BadStructure, "a statement that the end of the file cuts off", "its continuation: export the file again");
        }
    }

    private static string Unquoted(string text)
    {
        var quotes = text.Split('\'');
        return quotes.Length > 1 ? quotes[1] : text.Trim();
    }
}
