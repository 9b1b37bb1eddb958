namespace ErrorMatching.Measurement;

/// <summary>Reads a table with one row per coordinate of a feature.</summary>
internal static class FeatureRows
{
    public static (
        IReadOnlyList<LabelledPoint> Actuals,
        IReadOnlyList<LabelledPoint> Nominals,
        Place Labels) Read(Table table, MeasurementFormat format, FeatureTableColumns columns)
    {
        var (feature, item) = (table.Find(columns.Feature), table.Find(columns.Item));
        var (nominal, actual) = (table.Find(columns.Nominal), table.Find(columns.Actual));
        var deviation = columns.Deviation is { } selector ? table.Find(selector) : -1;
        var points = new AxisPoints(format.MaxPoints);
        var deviations = new DeviationCheck();
        foreach (var row in table.Rows)
        {
            var (name, axis) = (table.Cell(row, feature), table.Cell(row, item));
            _ = name.Label();
            var axisName = axis.Label().ToUpperInvariant();
            if (axisName is not ("X" or "Y" or "Z"))
            {
                continue;
            }

            if (deviation >= 0)
            {
                deviations.Add(table.Cell(row, nominal), table.Cell(row, actual), table.Cell(row, deviation));
            }

            points.Add(
                name,
                axis,
                axisName[0],
                Coordinate.Read(table.Cell(row, nominal), format.Unit),
                Coordinate.Read(table.Cell(row, actual), format.Unit));
        }

        deviations.Run();
        var content = points.Content(format.Unit, table.Top(feature));
        return content.Incomplete is [var (label, lacks, place), ..]
            ? throw place.Fail(
                MeasurementError.MissingCoordinate,
                $"feature {MeasurementRefusal.Quote(label)} without a line for {lacks}",
                "a line for X and one for Y of each feature that is a point")
            : (content.Points, content.Nominals, content.Labels);
    }
}
