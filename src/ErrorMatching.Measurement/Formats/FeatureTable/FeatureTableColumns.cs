namespace ErrorMatching.Measurement;

/// <summary>The columns of a file with one line per coordinate of a feature. Lines whose item is not X, Y or Z (a diameter, an angle) are
/// skipped.</summary>
/// <param name="Feature">Name of the feature, which becomes the label of its point.</param>
/// <param name="Item">The item of the line: X, Y, Z or something else.</param>
/// <param name="Nominal">The nominal value.</param>
/// <param name="Actual">The measured value.</param>
/// <param name="Deviation">Actual - nominal, checked against both; null if the file has none.</param>
internal sealed record FeatureTableColumns(
    ColumnSelector Feature, ColumnSelector Item, ColumnSelector Nominal, ColumnSelector Actual, ColumnSelector? Deviation)
    : MeasurementColumns
{
    /// <inheritdoc/>
    public override string Kind => "feature-table";

    internal override IEnumerable<ColumnSelector> Required =>
        Deviation is { } d ? [Feature, Item, Nominal, Actual, d] : [Feature, Item, Nominal, Actual];

    internal override IReadOnlyList<(string Name, bool IsOptional)> Members =>
        [("feature", false), ("item", false), ("nominal", false), ("actual", false), ("deviation", true)];

    internal override MeasurementColumns With(string member, ColumnSelector? column) => member switch
    {
        "feature" => this with { Feature = column!.Value },
        "item" => this with { Item = column!.Value },
        "nominal" => this with { Nominal = column!.Value },
        "actual" => this with { Actual = column!.Value },
        _ => this with { Deviation = column },
    };

    internal override (
        IReadOnlyList<LabelledPoint> Points,
        IReadOnlyList<LabelledPoint> Nominals,
        Place Labels) Read(Table table, MeasurementFormat format) =>
        FeatureRows.Read(table, format, this);
}

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
