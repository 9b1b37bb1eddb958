namespace ErrorMatching.Measurement;

/// <summary>The columns of a file with one line per point.</summary>
/// <param name="Label">Name of the point.</param>
/// <param name="X">First coordinate.</param>
/// <param name="Y">Second coordinate.</param>
/// <param name="Z">Third coordinate; null if it is ignored. A column given by name may be missing in the file.</param>
public sealed record PointColumns(ColumnSelector Label, ColumnSelector X, ColumnSelector Y, ColumnSelector? Z) : MeasurementColumns
{
    /// <inheritdoc/>
    public override string Kind => "points";

    internal override IEnumerable<ColumnSelector> Required => Z is { Name: null } z ? [Label, X, Y, z] : [Label, X, Y];

    internal override IReadOnlyList<(string Name, bool IsOptional)> Members => [("label", false), ("x", false), ("y", false), ("z", true)];

    internal override MeasurementColumns With(string member, ColumnSelector? column) => member switch
    {
        "label" => this with { Label = column!.Value },
        "x" => this with { X = column!.Value },
        "y" => this with { Y = column!.Value },
        _ => this with { Z = column },
    };

    internal override (
        IReadOnlyList<LabelledPoint> Points,
        IReadOnlyList<LabelledPoint> Nominals,
        Place Labels) Read(Table table, MeasurementFormat format)
    {
        var (points, labels) = PointRows.Read(table, format, this);
        return (points, [], labels);
    }
}
