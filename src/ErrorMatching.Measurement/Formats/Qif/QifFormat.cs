using System.Text;
using System.Xml;
using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Measurement;

/// <summary>QIF 3.0 results (ANSI/DMSC QIF 3.0, ISO 23952).</summary>
internal sealed class QifFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        head.AsSpan().TrimStart() is ['<', ..] && head.Contains("QIFDocument", StringComparison.Ordinal);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new QifReader(source).Read();
}

/// <summary>Reads the measured points of a document: those with a location, named by their feature items.</summary>
/// <remarks>The document is read once, from the beginning to the end, without a tree. A document type is refused, and nothing outside
/// the document is opened.</remarks>
internal sealed class QifReader(MeasurementBytes source)
{
    public const string Namespace = "http://qifstandards.org/xsd/qif3";

    private const int Deepest = 100;

    private static readonly string[] Kinds = ["PointFeature", "EdgePointFeature"];

    private readonly List<string> _path = [];
    private readonly Dictionary<string, QifFeature> _nominals = new(StringComparer.Ordinal);
    private readonly Dictionary<string, QifFeature> _items = new(StringComparer.Ordinal);
    private readonly List<QifFeature> _measured = [];
    private readonly List<HeaderField> _fields = [];
    private readonly StringBuilder _text = new();
    private QifFeature? _feature;
    private int _results;
    private Place _factorPlace;
    private Cell? _factor;

    public MeasuredContent Read()
    {
        try
        {
            using var nodes = new XmlNodes(source.Bytes);
            while (nodes.Read())
            {
                Visit(nodes.Xml);
            }
        }
        catch (XmlException e)
        {
            throw (e.LineNumber > 0 ? PlaceOf(e.LineNumber, e.LinePosition) : DocumentType()).Fail(
                MeasurementError.BadStructure,
                "XML that cannot be read: " + MeasurementRefusal.Quote(e.Message),
                "a whole QIF document: export it again",
                e);
        }
        catch (Exception e) when (e is NotSupportedException or ArgumentException)
        {
            throw Place.Start(source.File).Fail(
                MeasurementError.InvalidEncoding, "XML in an encoding that is not known", "UTF-8 or UTF-16", e);
        }

        return Content();
    }

    private void Visit(XmlReader xml)
    {
        switch (xml.NodeType)
        {
            case XmlNodeType.Element:
                var isEmpty = xml.IsEmptyElement;
                Begin(xml, PlaceOf(xml));
                if (isEmpty)
                {
                    End();
                }

                break;
            case XmlNodeType.Text or XmlNodeType.CDATA:
                _text.Append(xml.Value);
                break;
            case XmlNodeType.EndElement:
                End();
                break;
        }
    }

    private void Begin(XmlReader xml, Place place)
    {
        var (name, parent) = (xml.LocalName, Parent(0));
        if (_path.Count == 0 && (name != "QIFDocument" || xml.NamespaceURI != Namespace))
        {
            throw place.Fail(
                MeasurementError.UnsupportedVersion,
                $"the document {MeasurementRefusal.Quote(name)} of {MeasurementRefusal.Quote(xml.NamespaceURI)}",
                $"a QIFDocument of QIF 3.0, {MeasurementRefusal.Quote(Namespace)}: export it as QIF 3.0");
        }

        if (_path.Count >= Deepest)
        {
            throw place.Fail(MeasurementError.BadStructure, $"more than {Deepest} elements in one another", "a QIF document");
        }

        _path.Add(name);
        _text.Clear();
        if (name == "MeasurementResults" && parent == "MeasurementResultsSet" && ++_results > 1)
        {
            throw place.Fail(
                MeasurementError.SeveralMeasurements, "the results of a second measurement", "one: export that of one piece alone");
        }

        if (Kinds.Any(k => name.StartsWith(k, StringComparison.Ordinal))
            && parent is "FeatureNominals" or "FeatureItems" or "MeasuredFeatures")
        {
            _feature = new(xml.GetAttribute("id") ?? "", place, _path.Count);
            Add(_feature, parent);
        }

        if (name == "Location" && _feature?.Depth == _path.Count - 1)
        {
            if (xml.GetAttribute("linearUnit") is { } unit)
            {
                throw place.Fail(
                    MeasurementError.UnknownUnit,
                    $"a point in the unit {MeasurementRefusal.Quote(unit)}",
                    "points in the primary unit of the document: export it again");
            }

            _feature.LocationPlace = place;
        }

        if (name == "Factor")
        {
            _factorPlace = place;
        }
    }

    private void Add(QifFeature feature, string list)
    {
        if (list == "MeasuredFeatures")
        {
            _measured.Add(feature);
        }
        else if (!(list == "FeatureItems" ? _items : _nominals).TryAdd(feature.Id, feature))
        {
            throw feature.Place.Fail(
                MeasurementError.BadStructure, $"a second feature with the id {MeasurementRefusal.Quote(feature.Id)}", "different ids");
        }
    }

    private void End()
    {
        var (name, text) = (_path[^1], _text.ToString().Trim());
        _path.RemoveAt(_path.Count - 1);
        _text.Clear();
        if (_feature is { } feature && feature.Depth == _path.Count)
        {
            feature.Set(name, text);
        }
        else if (_feature?.Depth > _path.Count)
        {
            _feature = null;
        }
        else if (name == "Factor" && Parent(0) == "UnitConversion" && Parent(1) == "LinearUnit" && Parent(2) == "PrimaryUnits")
        {
            _factor = new(text, _factorPlace, "Factor of the linear unit", false);
        }
        else if ((name == "ModelNumber" && Parent(0) == "Part") || (name == "SerialNumber" && Parent(0) == "ActualComponent"))
        {
            _fields.Add(new(name, text, 1));
        }
    }

    private string Parent(int level) => _path.Count > level ? _path[^(level + 1)] : "";

    private MeasuredContent Content()
    {
        var start = Place.Start(source.File);
        var unit = Unit(start);
        var points = new List<LabelledPoint>();
        var nominals = new List<LabelledPoint>();
        var incomplete = new List<(string, char, Place)>();
        var lines = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (var feature in _measured)
        {
            var item = feature.ItemId is null ? null : _items.GetValueOrDefault(feature.ItemId);
            var label = new Cell(
                feature.Name ?? item?.Name ?? throw feature.Place.Fail(
                    MeasurementError.BadStructure, "a measured point without a name", "FeatureName, or a feature item that has one"),
                feature.Place,
                "FeatureName",
                false);
            if (!lines.TryAdd(label.Label(), feature.Place.Line))
            {
                throw label.Fail(MeasurementError.DuplicatePoint, $"each point once: line {lines[label.Text]} has this one already");
            }

            if (feature.Location is null)
            {
                incomplete.Add((label.Text, 'X', feature.Place));
                continue;
            }

            Coordinate.ThrowIfTooMany(points.Count + 1, label, SelfDescribingFormat.MaxPoints);
            points.Add(new(label.Text, Position(feature, unit), true, feature.Place.Line));
            if (item?.NominalId is { } id && _nominals.TryGetValue(id, out var nominal) && nominal.Location is not null)
            {
                nominals.Add(new(label.Text, Position(nominal, unit), true, feature.Place.Line));
            }
        }

        return points.Count > 0 || incomplete.Count > 0
            ? new(unit, points, nominals.Count == points.Count ? nominals : [], start) { Fields = _fields, Incomplete = incomplete }
            : throw start.Fail(
                MeasurementError.NoPoints,
                _results == 0 ? "a QIF document without results" : "results without points",
                "MeasuredFeatures with a PointFeatureMeasurement for each point");
    }

    private static Point3 Position(QifFeature feature, LengthUnit unit)
    {
        var words = feature.Location!.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 3)
        {
            throw feature.LocationPlace.Fail(
                MeasurementError.BadStructure, MeasurementRefusal.Quote(feature.Location) + " as a location", "three numbers");
        }

        var numbers = words.Select((w, i) => new Cell(w, feature.LocationPlace, "XYZ"[i].ToString(), false))
            .Select(c => Coordinate.Read(c, unit))
            .ToArray();
        return new(numbers[0], numbers[1], numbers[2]);
    }

    // The factor converts the primary unit to meters.
    private LengthUnit Unit(Place start)
    {
        if (_factor is not { } factor)
        {
            throw start.Fail(
                MeasurementError.UnknownUnit, "no primary linear unit", "FileUnits with the unit of lengths: export the document again");
        }

        return factor.Number().Value switch
        {
            0.001 => LengthUnit.Millimeter,
            0.0254 => LengthUnit.Inch,
            _ => throw factor.Fail(MeasurementError.UnknownUnit, "0.001 (mm) or 0.0254 (inch): export the document again"),
        };
    }

    private Place PlaceOf(XmlReader xml) => PlaceOf(((IXmlLineInfo)xml).LineNumber, ((IXmlLineInfo)xml).LinePosition);

    // The reader refuses a document type without saying where it is.
    private Place DocumentType()
    {
        var at = source.Bytes.Span.IndexOf("<!DOCTYPE"u8);
        return PlaceOf(at < 0 ? 1 : 1 + LineBreaks.Count(Encoding.Latin1.GetString(source.Bytes.Span[..at])), 1);
    }

    private Place PlaceOf(int line, int column) => new(source.File, Math.Max(line, 1), Math.Max(column, 1));

    // A nominal point, a feature item or a measured point.
    private sealed class QifFeature(string id, Place place, int depth)
    {
        public string Id => id;

        public Place Place { get; } = place;

        /// <summary>Number of elements around its parts.</summary>
        public int Depth => depth;

        public string? Name { get; private set; }

        public string? ItemId { get; private set; }

        public string? NominalId { get; private set; }

        public string? Location { get; private set; }

        public Place LocationPlace { get; set; } = place;

        public void Set(string name, string text)
        {
            switch (name)
            {
                case "FeatureName":
                    Name = text;
                    break;
                case "FeatureItemId":
                    ItemId = text;
                    break;
                case "FeatureNominalId":
                    NominalId = text;
                    break;
                case "Location":
                    Location = text;
                    break;
            }
        }
    }
}
