using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

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
