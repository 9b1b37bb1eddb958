using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The points of one measurement, in millimeters, with their provenance.</summary>
public sealed class MeasurementFile
{
    private readonly Dictionary<string, LabelledPoint> _byLabel;
    private readonly Table _table;
    private readonly Place _labels;

    internal MeasurementFile(
        string sha256,
        LengthUnit unit,
        Table table,
        Place labels,
        IReadOnlyList<LabelledPoint> points,
        IReadOnlyList<LabelledPoint> nominals)
    {
        (Sha256, Unit, _table, _labels) = (sha256, unit, table, labels);
        (Points, Nominals) = (points, nominals);
        _byLabel = points.ToDictionary(p => p.Label, StringComparer.Ordinal);
    }

    /// <summary>The file name, as given by the caller.</summary>
    public string File => _table.File;

    /// <summary>SHA-256 of the file's bytes as 64 lowercase hexadecimal digits.</summary>
    public string Sha256 { get; }

    /// <summary>The unit in the file. The points are always in millimeters.</summary>
    public LengthUnit Unit { get; }

    /// <summary>The measured points in the order of the file.</summary>
    public IReadOnlyList<LabelledPoint> Points { get; }

    /// <summary>The nominal points of a feature table, in the same order; empty for the kind <c>points</c>.</summary>
    public IReadOnlyList<LabelledPoint> Nominals { get; }

    /// <summary>Names and values in the lines above the table, in the order of the file.</summary>
    public IReadOnlyList<HeaderField> HeaderFields => _table.Fields;

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
    public IReadOnlyList<string>? ColumnTexts(string name) => _table.TextsOf(name);

    private InputException Missing(string label)
    {
        var other = Points.FirstOrDefault(p => string.Equals(p.Label, label, StringComparison.OrdinalIgnoreCase)).Label;
        return _labels.Fail(
            MeasurementError.MissingPoint,
            $"no point {MeasurementRefusal.Quote(label)} among the {Points.Count} of the file"
                + (other is null ? "" : $" (but {MeasurementRefusal.Quote(other)})"),
            $"a point {MeasurementRefusal.Quote(label)}: measure it, or correct the label");
    }
}
