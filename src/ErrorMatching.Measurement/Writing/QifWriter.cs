using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using System.Xml;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>Writes the result of a piece as a QIF 3.0 document: each point as a feature with nominal and measured location, and its
/// deviation along the normal as a point profile with its limits.</summary>
/// <remarks>UTF-8 without a byte order mark, lines end with a line feed. The document's identifier is made of its content, so the same
/// result gives the same bytes. It has no time, because the library has no clock.</remarks>
public sealed class QifWriter
{
    private readonly PieceResult _piece;
    private readonly XmlWriter _xml;
    private readonly (double LowerMm, double UpperMm)[] _bands;
    private int _lastId;

    private QifWriter(PieceResult piece, XmlWriter xml)
    {
        (_piece, _xml) = (piece, xml);
        _bands = [.. piece.Points.Select(p => p.Limits).OfType<(double LowerMm, double UpperMm)>().Distinct()];
    }

    /// <summary>The result as a file.</summary>
    /// <param name="piece">The result.</param>
    public static byte[] Write(PieceResult piece)
    {
        ArgumentNullException.ThrowIfNull(piece);
        using var stream = new MemoryStream();
        using (var xml = XmlWriter.Create(stream, new()
        {
            Encoding = new UTF8Encoding(false),
            Indent = true,
            NewLineChars = "\n",
        }))
        {
            new QifWriter(piece, xml).Document();
        }

        stream.WriteByte((byte)'\n');
        return stream.ToArray();
    }

    private void Document()
    {
        // Each point has a nominal, an item and a measurement, with limits a characteristic item and its measurement, too.
        var toleranced = _piece.Points.Count(p => p.Limits is not null);
        var most = 2 + (3 * _piece.Points.Count) + (_bands.Length > 0 ? 2 + (2 * _bands.Length) + (2 * toleranced) : 0);
        _xml.WriteStartElement("QIFDocument", QifReader.Namespace);
        _xml.WriteAttributeString("versionQIF", "3.0.0");
        _xml.WriteAttributeString("idMax", Text(most));
        Leaf("QPId", Identifier());
        Within("Header", () =>
        {
            Within("Application", () => Leaf("Name", "ErrorMatching"));
            Leaf("Description", Clean(_piece.WorkOrder is { Length: > 0 } order ? $"{_piece.Name} ({order})" : _piece.Name));
            Leaf("Scope", "Results");
        });
        var standard = _bands.Length > 0 ? NextId() : 0;
        if (standard > 0)
        {
            Standard(standard);
        }

        Units();
        var frame = _bands.Length > 0 ? NextId() : 0;
        if (frame > 0)
        {
            List("DatumReferenceFrames", 1, () => Element("DatumReferenceFrame", frame, () => { }));
        }

        var items = Features();
        var characteristics = _bands.Length > 0 ? Characteristics(standard, frame, items) : [];
        Results(items, characteristics);
        _xml.WriteEndElement();
    }

    private void Standard(int id) => List("StandardsDefinitions", 1, () => Element("Standard", id, () =>
    {
        Within("Organization", () => Leaf("StandardsOrganizationEnum", "ISO"));
        Leaf("Designator", "1101");
        Leaf("Year", "2017");
    }));

    private void Units() => Within("FileUnits", () => Within("PrimaryUnits", () => Within("LinearUnit", () =>
    {
        Leaf("SIUnitName", "meter");
        Leaf("UnitName", "mm");
        Within("UnitConversion", () => Leaf("Factor", "0.001"));
    })));

    // The feature items of the points, in their order.
    private int[] Features()
    {
        var points = _piece.Points;
        var definition = NextId();
        var nominals = points.Select(_ => NextId()).ToArray();
        var items = points.Select(_ => NextId()).ToArray();
        Within("Features", () =>
        {
            List("FeatureDefinitions", 1, () => Element("PointFeatureDefinition", definition, () => { }));
            Each("FeatureNominals", "PointFeatureNominal", nominals, i =>
            {
                Leaf("FeatureDefinitionId", Text(definition));
                Leaf("Location", Location(points[i].Nominal));
                Leaf("Normal", Direction(points[i].Normal));
            });
            Each("FeatureItems", "PointFeatureItem", items, i =>
            {
                Leaf("FeatureNominalId", Text(nominals[i]));
                Leaf("FeatureName", Clean(points[i].Label));
                Within("DeterminationMode", () => Within("Checked", () => Within("CheckDetails", () => Within("Measured", () => { }))));
            });
        });
        return items;
    }

    // The characteristic items of the points that have limits, in their order.
    private int[] Characteristics(int standard, int frame, int[] features)
    {
        var toleranced = Toleranced();
        var definitions = _bands.Select(_ => NextId()).ToArray();
        var nominals = _bands.Select(_ => NextId()).ToArray();
        var items = toleranced.Select(_ => NextId()).ToArray();
        Within("Characteristics", () =>
        {
            Leaf("FormalStandardId", Text(standard));
            Each("CharacteristicDefinitions", "PointProfileCharacteristicDefinition", definitions, i =>
            {
                Leaf("ToleranceValue", WrittenNumber.Of(_bands[i].UpperMm - _bands[i].LowerMm));
                Leaf("OuterDisposition", WrittenNumber.Of(_bands[i].UpperMm));
                Leaf("DatumReferenceFrameId", Text(frame));
            });
            Each("CharacteristicNominals", "PointProfileCharacteristicNominal", nominals, i =>
                Leaf("CharacteristicDefinitionId", Text(definitions[i])));
            Each("CharacteristicItems", "PointProfileCharacteristicItem", items, i =>
            {
                Leaf("Name", Clean(_piece.Points[toleranced[i]].Label));
                Ids("FeatureItemIds", features[toleranced[i]]);
                Leaf("CharacteristicNominalId", Text(nominals[Array.IndexOf(_bands, _piece.Points[toleranced[i]].Limits!.Value)]));
            });
        });
        return items;
    }

    private void Results(int[] items, int[] characteristics) =>
        Within("Results", () => List("MeasurementResultsSet", 1, () => Element("MeasurementResults", NextId(), () =>
        {
            var measured = items.Select(_ => NextId()).ToArray();
            Each("MeasuredFeatures", "PointFeatureMeasurement", measured, i =>
            {
                Leaf("FeatureItemId", Text(items[i]));
                Leaf("Location", Location(_piece.Points[i].Actual));
            });
            if (characteristics.Length > 0)
            {
                var toleranced = Toleranced();
                var ids = characteristics.Select(_ => NextId()).ToArray();
                Within("MeasuredCharacteristics", () => Each(
                    "CharacteristicMeasurements", "PointProfileCharacteristicMeasurement", ids, i =>
                    {
                        var point = _piece.Points[toleranced[i]];
                        Within("Status", () => Leaf("CharacteristicStatusEnum", point.IsWithinLimits == true ? "PASS" : "FAIL"));
                        Leaf("CharacteristicItemId", Text(characteristics[i]));
                        Ids("FeatureMeasurementIds", measured[toleranced[i]]);
                        Leaf("Value", WrittenNumber.Of(point.DeviationMm));
                    }));
            }

            Within("InspectionStatus", () => Leaf("InspectionStatusEnum", _piece.IsWithinLimits switch
            {
                true => "PASS",
                false => "FAIL",
                _ => "UNKNOWN",
            }));
        })));

    private int[] Toleranced() => [.. Enumerable.Range(0, _piece.Points.Count).Where(i => _piece.Points[i].Limits is not null)];

    private int NextId() => ++_lastId;

    private void Each(string list, string element, int[] ids, Action<int> content) => List(list, ids.Length, () =>
    {
        for (var i = 0; i < ids.Length; i++)
        {
            var at = i;
            Element(element, ids[i], () => content(at));
        }
    });

    private void Ids(string list, int id) => List(list, 1, () => Leaf("Id", Text(id)));

    private void List(string name, int count, Action content) => Within(name, content, "n", count);

    private void Element(string name, int id, Action content) => Within(name, content, "id", id);

    private void Within(string name, Action content, string? attribute = null, int value = 0)
    {
        _xml.WriteStartElement(name);
        if (attribute is not null)
        {
            _xml.WriteAttributeString(attribute, Text(value));
        }

        content();
        _xml.WriteEndElement();
    }

    private void Leaf(string name, string text) => _xml.WriteElementString(name, text);

    private static string Location(Point3 point) =>
        $"{WrittenNumber.Of(point.X)} {WrittenNumber.Of(point.Y)} {WrittenNumber.Of(point.Z)}";

    private static string Direction(Vector3 vector) =>
        $"{WrittenNumber.OfUnit(vector.X)} {WrittenNumber.OfUnit(vector.Y)} {WrittenNumber.OfUnit(vector.Z)}";

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

    // Characters that XML does not have.
    private static string Clean(string text)
    {
        var clean = new StringBuilder(text.Length);
        foreach (var rune in text.EnumerateRunes())
        {
            clean.Append(rune.Value <= char.MaxValue && !XmlConvert.IsXmlChar((char)rune.Value) ? "\uFFFD" : rune.ToString());
        }

        return clean.ToString();
    }

    // A UUID of version 8 (RFC 9562): its other bits are free, here a hash of the result.
    private string Identifier()
    {
        var content = new StringBuilder($"{_piece.Name}\n{_piece.WorkOrder}\n{_piece.Sha256}\n");
        foreach (var point in _piece.Points)
        {
            content.Append(CultureInfo.InvariantCulture, $"{point.Label} {Location(point.Nominal)} {Location(point.Actual)} ")
                .Append(CultureInfo.InvariantCulture, $"{Direction(point.Normal)} {point.DeviationMm:R} {point.Limits}\n");
        }

        var hash = SHA256.HashData(Encoding.UTF8.GetBytes(content.ToString()))[..16];
        hash[6] = (byte)((hash[6] & 0x0F) | 0x80);
        hash[8] = (byte)((hash[8] & 0x3F) | 0x80);
        return new Guid(hash, bigEndian: true).ToString("D", CultureInfo.InvariantCulture);
    }
}
