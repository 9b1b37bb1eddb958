using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>The columns of a file with one line per point of a grid. The label of a point is <c>i,j</c>.</summary>
/// <param name="I">Index along the curve.</param>
/// <param name="J">Index of the curve.</param>
/// <param name="X">First coordinate.</param>
/// <param name="Y">Second coordinate.</param>
/// <param name="Z">Third coordinate.</param>
internal sealed record GridColumns(ColumnSelector I, ColumnSelector J, ColumnSelector X, ColumnSelector Y, ColumnSelector Z)
    : MeasurementColumns
{
    /// <inheritdoc/>
    public override string Kind => "grid";

    internal override IEnumerable<ColumnSelector> Required => [I, J, X, Y, Z];

    internal override IReadOnlyList<(string Name, bool IsOptional)> Members =>
        [("i", false), ("j", false), ("x", false), ("y", false), ("z", false)];

    internal override MeasurementColumns With(string member, ColumnSelector? column) => member switch
    {
        "i" => this with { I = column!.Value },
        "j" => this with { J = column!.Value },
        "x" => this with { X = column!.Value },
        "y" => this with { Y = column!.Value },
        _ => this with { Z = column!.Value },
    };

    internal override (
        IReadOnlyList<LabelledPoint> Points,
        IReadOnlyList<LabelledPoint> Nominals,
        Place Labels) Read(Table table, MeasurementFormat format)
    {
        var (i, j) = (table.Find(I), table.Find(J));
        var (x, y, z) = (table.Find(X), table.Find(Y), table.Find(Z));
        var points = new List<LabelledPoint>();
        var lines = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (var row in table.Rows)
        {
            var first = table.Cell(row, i);
            var label = $"{first.Whole()},{table.Cell(row, j).Whole()}";
            if (!lines.TryAdd(label, first.Place.Line))
            {
                throw first.Fail(MeasurementError.DuplicatePoint, $"each point once: line {lines[label]} has {label} already");
            }

            var position = new Point3(
                Coordinate.Read(table.Cell(row, x), format.Unit),
                Coordinate.Read(table.Cell(row, y), format.Unit),
                Coordinate.Read(table.Cell(row, z), format.Unit));
            Coordinate.ThrowIfTooMany(points.Count + 1, first, format.MaxPoints);
            points.Add(new(label, position, true, first.Place.Line));
        }

        return (points, [], table.Top(i));
    }
}
