using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The points of one measurement, in millimeters, with their provenance.</summary>
public sealed class MeasurementFile
{
    private readonly Dictionary<string, LabelledPoint> _byLabel;
    private readonly MeasurementBytes _source;
    private readonly MeasuredContent _content;

    internal MeasurementFile(MeasurementBytes source, MeasuredContent content)
    {
        (_source, _content) = (source, content);
        Sha256 = source.Sha256;
        _byLabel = content.Points.ToDictionary(p => p.Label, StringComparer.Ordinal);
    }

    /// <summary>The file name, as given by the caller.</summary>
    public string File => _source.File;

    /// <summary>The files that were read: the named one, and the description of its values (<c>.dfd</c>) if it has one.</summary>
    public IReadOnlyList<string> Files => _source.Files;

    /// <summary>SHA-256 of the bytes as 64 lowercase hexadecimal digits (<see cref="MeasurementBytes.Sha256"/>).</summary>
    public string Sha256 { get; }

    /// <summary>The unit in the file. The points are always in millimeters.</summary>
    public LengthUnit Unit => _content.Unit;

    /// <summary>The measured points in the order of the file.</summary>
    public IReadOnlyList<LabelledPoint> Points => _content.Points;

    /// <summary>The nominal points in the same order; empty if the file does not have all of them.</summary>
    public IReadOnlyList<LabelledPoint> Nominals => _content.Nominals;

    /// <summary>Names and values of what the file says about itself, in the order of the file: the lines above a table, or the fields
    /// about the part in a format that has such (<c>K1001</c>, <c>PARTID</c>, <c>SerialNumber</c>).</summary>
    public IReadOnlyList<HeaderField> HeaderFields => _content.Fields;

    /// <summary>The measured point with a name.</summary>
    /// <exception cref="InputException">The file has no such point (<see cref="MeasurementError.MissingPoint"/>).</exception>
    public LabelledPoint this[string label] => TryGet(label, out var point) ? point : throw Missing(label);

    /// <summary>Returns the measured point with a name, if there is one.</summary>
    public bool TryGet(string label, out LabelledPoint point) => _byLabel.TryGetValue(label, out point);

    /// <summary>Throws unless the file has all named points.</summary>
    /// <exception cref="InputException">The first missing point (<see cref="MeasurementError.MissingPoint"/>).</exception>
    public void Require(IEnumerable<string> labels)
    {
        foreach (var label in labels)
        {
            _ = this[label];
        }
    }

    /// <summary>The unparsed texts of a column in the order of the file; null if there is no such column.</summary>
    /// <param name="name">Name of the column; case is ignored.</param>
    public IReadOnlyList<string>? ColumnTexts(string name) => _content.Texts(name);

    private InputException Missing(string label)
    {
        if (_content.Incomplete.FirstOrDefault(p => string.Equals(p.Label, label, StringComparison.Ordinal)) is { Label: not null } part)
        {
            return part.Place.Fail(
                MeasurementError.MissingCoordinate,
                $"the point {MeasurementRefusal.Quote(label)} without {part.Axis}",
                "X and Y of each point: measure and export them");
        }

        var other = Points.FirstOrDefault(p => string.Equals(p.Label, label, StringComparison.OrdinalIgnoreCase)).Label;
        return _content.Labels.Fail(
            MeasurementError.MissingPoint,
            $"no point {MeasurementRefusal.Quote(label)} among the {Points.Count} of the file"
                + (other is null ? "" : $" (but {MeasurementRefusal.Quote(other)})"),
            $"a point {MeasurementRefusal.Quote(label)}: measure it, or correct the label");
    }
}
