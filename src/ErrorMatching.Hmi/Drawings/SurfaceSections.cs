using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The values of a surface along the two lines of its net through a place.</summary>
/// <param name="At">The place, seen from above.</param>
/// <param name="ValueMm">The value there.</param>
/// <param name="AlongU">The section along u.</param>
/// <param name="AlongV">The section along v.</param>
/// <param name="IsWorst">True if nobody chose the place: it is that of the largest value.</param>
public sealed record SurfaceSections(Point2 At, double ValueMm, MapSection AlongU, MapSection AlongV, bool IsWorst)
{
    /// <summary>The sections through a place.</summary>
    /// <param name="drawing">The surface with its values.</param>
    /// <param name="at">The place, seen from above; null, or a place off the piece, for that of the largest value without sign.</param>
    /// <returns>Null if there are no values.</returns>
    public static SurfaceSections? Of(SurfaceDrawing drawing, Point2? at)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        if (drawing is not { ValuesMm: { Count: > 0 } values, Net: { CountU: > 1, CountV: > 1 } net })
        {
            return null;
        }

        var chosen = at is { } place ? NetPlaces.Under(net, place) : null;
        var (u, v) = chosen ?? WorstOf(net, values);
        var position = NetPlaces.PositionAt(net, u, v);
        return new(
            new(position.X, position.Y),
            NetPlaces.ValueAt(net, values, u, v),
            Along(net, values, u, v, isAlongU: true),
            Along(net, values, u, v, isAlongU: false),
            IsWorst: chosen is null);
    }

    private static (double U, double V) WorstOf(SurfaceNet net, IReadOnlyList<double> values)
    {
        var worst = net.Inside().DefaultIfEmpty(0).MaxBy(p => Math.Abs(values[p]));
        return (worst / net.CountV, worst % net.CountV);
    }

    private static MapSection Along(SurfaceNet net, IReadOnlyList<double> values, double u, double v, bool isAlongU)
    {
        var outside = net.Outside.ToHashSet();
        var (count, across, own, other) = isAlongU ? (net.CountU, net.CountV, u, v) : (net.CountV, net.CountU, v, u);
        var (points, mm, isOpen) = (new List<SectionPoint>(), 0.0, false);
        for (var cell = 0; cell < count - 1; cell++)
        {
            var (from, to) = (PositionAt(cell), PositionAt(cell + 1));
            if (IsInside(cell))
            {
                if (!isOpen)
                {
                    // A point that is not finite interrupts the line.
                    points.AddRange(points.Count > 0 ? [SectionPoint.Gap] : Array.Empty<SectionPoint>());
                    points.Add(Point(cell, mm));
                }

                if (own > cell && own < cell + 1)
                {
                    points.Add(Point(own, mm + (PositionAt(own) - from).Length));
                }

                points.Add(Point(cell + 1, mm + (to - from).Length));
            }

            isOpen = IsInside(cell);
            mm += (to - from).Length;
        }

        var before = Math.Clamp((int)Math.Floor(own), 0, count - 2);
        return new(
            points,
            Enumerable.Range(0, before).Sum(c => (PositionAt(c + 1) - PositionAt(c)).Length)
                + (PositionAt(own) - PositionAt(before)).Length,
            mm);

        Point3 PositionAt(double place) => isAlongU ? NetPlaces.PositionAt(net, place, other) : NetPlaces.PositionAt(net, other, place);

        SectionPoint Point(double place, double at) => new(
            at,
            isAlongU ? NetPlaces.ValueAt(net, values, place, other) : NetPlaces.ValueAt(net, values, other, place),
            PositionAt(place) is var p ? new(p.X, p.Y) : default);

        // On a line between two cells, either of them is enough.
        bool IsInside(int cell) => new[] { Math.Floor(other), Math.Ceiling(other) - 1 }
            .Select(o => (int)o)
            .Any(o => o >= 0 && o < across - 1
                && !outside.Contains(isAlongU ? (cell * (net.CountV - 1)) + o : (o * (net.CountV - 1)) + cell));
    }
}

/// <summary>Values along a line on a surface.</summary>
/// <param name="Points">Its points; one that is not finite interrupts it.</param>
/// <param name="AtMm">Distance of the chosen place from the start.</param>
/// <param name="LengthMm">Length of the line across the whole net.</param>
public sealed record MapSection(IReadOnlyList<SectionPoint> Points, double AtMm, double LengthMm)
{
    /// <summary>The line seen from above.</summary>
    public IReadOnlyList<Point2> Above { get; } = [.. Points.Select(p => p.Above)];

    /// <summary>The values in µm over the distance in mm.</summary>
    public IReadOnlyList<Point2> Curve { get; } = [.. Points.Select(p => new Point2(p.Mm, SectionPoint.MicrometersPerMm * p.ValueMm))];
}

/// <summary>A point of a section.</summary>
/// <param name="Mm">Its distance from the start, along the surface.</param>
/// <param name="ValueMm">The value there.</param>
/// <param name="Above">Its position, seen from above.</param>
public readonly record struct SectionPoint(double Mm, double ValueMm, Point2 Above)
{
    /// <summary>What is drawn in µm is stored in mm.</summary>
    public const int MicrometersPerMm = 1000;

    /// <summary>A point that interrupts the line.</summary>
    public static SectionPoint Gap => new(double.NaN, double.NaN, new(double.NaN, double.NaN));
}
