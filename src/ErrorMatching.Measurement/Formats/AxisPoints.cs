using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>Points that a file states one coordinate at a time.</summary>
/// <param name="maxPoints">Maximum number of points.</param>
internal sealed class AxisPoints(int maxPoints)
{
    private readonly List<AxisPoint> _points = [];
    private readonly Dictionary<string, AxisPoint> _byLabel = new(StringComparer.Ordinal);

    /// <summary>Adds a coordinate.</summary>
    /// <param name="label">The name of the point.</param>
    /// <param name="axis">The cell that names the axis.</param>
    /// <param name="letter">The axis: X, Y or Z.</param>
    /// <param name="nominal">The nominal coordinate in millimeters; null if the file has none.</param>
    /// <param name="actual">The measured coordinate in millimeters.</param>
    /// <exception cref="Refusals.InputException">The point has this coordinate already, or there are too many points.</exception>
    public void Add(Cell label, Cell axis, char letter, double? nominal, double actual)
    {
        if (!_byLabel.TryGetValue(label.Text, out var point))
        {
            Coordinate.ThrowIfTooMany(_points.Count + 1, label, maxPoints);
            point = new(label.Text, label.Place);
            _byLabel.Add(label.Text, point);
            _points.Add(point);
        }

        ref var slot = ref point.Axes[letter - 'X'];
        if (slot is { } earlier)
        {
            throw axis.Fail(
                MeasurementError.DuplicatePoint,
                $"each coordinate of {MeasurementRefusal.Quote(label.Text)} once: line {earlier.Line} has this one already");
        }

        slot = (nominal, actual, axis.Place.Line);
    }

    /// <summary>The points that have X and Y.</summary>
    /// <param name="unit">The unit in the file.</param>
    /// <param name="labels">The location of the labels.</param>
    public MeasuredContent Content(LengthUnit unit, Place labels)
    {
        var whole = _points.Where(p => p.Lacks is null).ToArray();
        return new(
            unit,
            [.. whole.Select(p => p.At(a => a.Actual))],
            whole.All(p => p.HasNominal) ? [.. whole.Select(p => p.At(a => a.Nominal!.Value))] : [],
            labels)
        {
            Incomplete = [.. _points.Where(p => p.Lacks is not null).Select(p => (p.Label, p.Lacks!.Value, p.Place))],
        };
    }

    private sealed class AxisPoint(string label, Place place)
    {
        public string Label => label;

        public Place Place => place;

        public (double? Nominal, double Actual, int Line)?[] Axes { get; } = new (double?, double, int)?[3];

        public char? Lacks => Axes[0] is null ? 'X' : Axes[1] is null ? 'Y' : null;

        public bool HasNominal => Axes.All(a => a is null or { Nominal: not null });

        public LabelledPoint At(Func<(double? Nominal, double Actual, int Line), double> value) => new(
            label,
            new Point3(value(Axes[0]!.Value), value(Axes[1]!.Value), Axes[2] is { } z ? value(z) : 0),
            Axes[2] is not null,
            place.Line);
    }
}
