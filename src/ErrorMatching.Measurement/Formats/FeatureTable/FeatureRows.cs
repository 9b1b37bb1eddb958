using ErrorMatching.Geometry;

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
        var features = new List<FeatureCoordinates>();
        var byName = new Dictionary<string, FeatureCoordinates>(StringComparer.Ordinal);
        var deviations = new DeviationCheck();
        foreach (var row in table.Rows)
        {
            var (name, axis) = (table.Cell(row, feature), table.Cell(row, item));
            var (label, axisName) = (name.Label(), axis.Label());
            if (axisName.ToUpperInvariant() is not ("X" or "Y" or "Z"))
            {
                continue;
            }

            if (!byName.TryGetValue(label, out var coordinates))
            {
                Coordinate.ThrowIfTooMany(features.Count + 1, name, format);
                coordinates = new(label, name.Place);
                byName.Add(label, coordinates);
                features.Add(coordinates);
            }

            if (deviation >= 0)
            {
                deviations.Add(table.Cell(row, nominal), table.Cell(row, actual), table.Cell(row, deviation));
            }

            coordinates.Add(axis, Coordinate.Read(table.Cell(row, nominal), format), Coordinate.Read(table.Cell(row, actual), format));
        }

        deviations.Run();
        return ([.. features.Select(f => f.Actual())], [.. features.Select(f => f.Nominal())], table.Top(feature));
    }

    private sealed class FeatureCoordinates(string label, Place place)
    {
        private readonly (double Nominal, double Actual, int Line)?[] _axes = new (double, double, int)?[3];

        public void Add(Cell axis, double nominal, double actual)
        {
            ref var slot = ref _axes[char.ToUpperInvariant(axis.Text[0]) - 'X'];
            if (slot is { } earlier)
            {
                throw axis.Fail(
                    MeasurementError.DuplicatePoint,
                    $"each coordinate of feature {MeasurementRefusal.Quote(label)} once: line {earlier.Line} has this one already");
            }

            slot = (nominal, actual, axis.Place.Line);
        }

        public LabelledPoint Nominal() => Point(a => a.Nominal);

        public LabelledPoint Actual() => Point(a => a.Actual);

        private LabelledPoint Point(Func<(double Nominal, double Actual, int Line), double> value) =>
            new(label, new Point3(value(Axis(0)), value(Axis(1)), _axes[2] is { } z ? value(z) : 0), _axes[2] is not null, place.Line);

        private (double Nominal, double Actual, int Line) Axis(int index) => _axes[index] ?? throw place.Fail(
            MeasurementError.MissingCoordinate,
            $"feature {MeasurementRefusal.Quote(label)} without a line for {"XY"[index]}",
            "a line for X and one for Y of each feature that is a point");
    }
}
