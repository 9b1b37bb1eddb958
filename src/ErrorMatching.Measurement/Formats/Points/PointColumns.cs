using ErrorMatching.Geometry;

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

/// <summary>Reads a table with one row per point.</summary>
internal static class PointRows
{
    public static (IReadOnlyList<LabelledPoint> Points, Place Labels) Read(Table table, MeasurementFormat format, PointColumns columns)
    {
        var (label, x, y) = (table.Find(columns.Label), table.Find(columns.X), table.Find(columns.Y));
        var z = columns.Z is { } selector ? table.FindOptional(selector) : -1;
        var points = new List<LabelledPoint>();
        var lines = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (var row in table.Rows)
        {
            var name = table.Cell(row, label);
            if (!lines.TryAdd(name.Label(), name.Place.Line))
            {
                throw name.Fail(MeasurementError.DuplicatePoint, $"each point once: line {lines[name.Text]} has this one already");
            }

            var position = new Point3(
                Coordinate.Read(table.Cell(row, x), format.Unit),
                Coordinate.Read(table.Cell(row, y), format.Unit),
                z < 0 ? 0 : Coordinate.Read(table.Cell(row, z), format.Unit));
            Coordinate.ThrowIfTooMany(points.Count + 1, name, format.MaxPoints);
            points.Add(new(name.Text, position, z >= 0, name.Place.Line));
        }

        return (points, table.Top(label));
    }
}
