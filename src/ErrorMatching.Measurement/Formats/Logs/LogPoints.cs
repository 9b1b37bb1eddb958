using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>The points of a log, each of which is in one line.</summary>
/// <param name="file">The file name, for messages.</param>
/// <param name="unit">The unit of the coordinates.</param>
/// <param name="maxPoints">Maximum number of points.</param>
internal sealed class LogPoints(string file, LengthUnit unit, int maxPoints = SelfDescribingFormat.MaxPoints)
{
    private readonly List<LabelledPoint> _points = [];
    private readonly Dictionary<string, int> _lines = new(StringComparer.Ordinal);

    /// <summary>Adds a point.</summary>
    /// <param name="label">Its label; null in a log whose points have none.</param>
    /// <param name="x">The first coordinate.</param>
    /// <param name="y">The second coordinate.</param>
    /// <param name="z">The third coordinate; null if the log has none.</param>
    /// <exception cref="Refusals.InputException">A coordinate is no number, the label occurs twice, or there are too many
    /// points.</exception>
    public void Add(Cell? label, Cell x, Cell y, Cell? z) => Add(
        label,
        new(Coordinate.Read(x, unit), Coordinate.Read(y, unit), z is { } third ? Coordinate.Read(third, unit) : 0),
        z is not null,
        x);

    /// <summary>Adds a point whose place is known.</summary>
    /// <param name="label">Its label; null in a log whose points have none.</param>
    /// <param name="position">The point in millimeters.</param>
    /// <param name="hasZ">True if it has a Z.</param>
    /// <param name="cell">A cell of it, for messages.</param>
    public void Add(Cell? label, Point3 position, bool hasZ, Cell cell)
    {
        Coordinate.ThrowIfTooMany(_points.Count + 1, cell, maxPoints);
        var name = label?.Label() ?? (_points.Count + 1).ToString(CultureInfo.InvariantCulture);
        if (!_lines.TryAdd(name, cell.Place.Line))
        {
            throw (label ?? cell).Fail(
                MeasurementError.DuplicatePoint, $"each point once: line {_lines[name]} has this one already");
        }

        _points.Add(new(name, position, hasZ, cell.Place.Line));
    }

    /// <summary>The content of the log.</summary>
    /// <param name="isByOrder">True if its points have no labels.</param>
    public MeasuredContent Content(bool isByOrder) =>
        new(unit, _points, [], Place.Start(file)) { IsByOrder = isByOrder, HasNumbers = !isByOrder };
}
