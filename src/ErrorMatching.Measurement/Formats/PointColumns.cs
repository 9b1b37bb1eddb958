namespace ErrorMatching.Measurement;

/// <summary>The columns of a file with one line per point.</summary>
/// <param name="Label">Name of the point.</param>
/// <param name="X">First coordinate.</param>
/// <param name="Y">Second coordinate.</param>
/// <param name="Z">Third coordinate; null if it is not to be read. A column given by name may be absent from the file.</param>
public sealed record PointColumns(ColumnSelector Label, ColumnSelector X, ColumnSelector Y, ColumnSelector? Z) : MeasurementColumns
{
    /// <inheritdoc/>
    public override MeasurementKind Kind => MeasurementKind.Points;

    internal override IEnumerable<ColumnSelector> Required => Z is { Name: null } z ? [Label, X, Y, z] : [Label, X, Y];
}
