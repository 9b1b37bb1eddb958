using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A feature in a drawing of the assembly: a boundary and its deviations, interpolated linearly between the key
/// points.</summary>
internal sealed class DrawnFeature
{
    private readonly DrawnOutline _outline;
    private readonly int _side;
    private readonly PlacedPoint[] _stations;

    private DrawnFeature(DrawnOutline outline, IReadOnlyList<DrawnPoint> points)
    {
        Points = points;
        _stations = [.. points.Select(p => new PlacedPoint(outline.Nearest(p.At), p)).OrderBy(s => s.Station)];

        // Each key point becomes a vertex, because the deviation can change its slope there.
        _outline = outline.WithVertices(_stations.Select(s => s.Station));
        var sides = _stations.Sum(s => _outline.Left(_outline.SegmentAt(s.Station)).Dot(s.Point.Normal));
        _side = sides < 0 ? -1 : 1;
    }

    /// <summary>Its key points.</summary>
    public IReadOnlyList<DrawnPoint> Points { get; }

    /// <summary>Number of straight pieces of its boundary.</summary>
    public int Segments => _outline.Segments;

    /// <summary>Where the boundary begins.</summary>
    public Point2 Start => _outline.Vertex(0);

    /// <summary>Where it ends.</summary>
    public Point2 End => _outline.Vertex(Segments);

    private bool IsClosed => _stations.Length > 1 && Start.DistanceTo(End) <= 1e-6 * _outline.StationOf(Segments);

    /// <summary>A feature, or null with fewer than two known places. Without an outline, its key points form one.</summary>
    public static DrawnFeature? Of(IReadOnlyList<Point2> outline, IReadOnlyList<DrawnPoint> points) =>
        points.Count > 0 && DrawnOutline.Of(outline.Count >= 2 ? outline : [.. points.Select(p => p.At)]) is { } drawn
            ? new(drawn, points)
            : null;

    /// <summary>A vertex of the boundary.</summary>
    public Point2 Vertex(int index) => _outline.Vertex(index);

    /// <summary>Unit normal of a piece, into the part.</summary>
    public Vector2 Normal(int segment) => _outline.Left(segment) * _side;

    /// <summary>The deviation at a vertex: interpolated between key points, and across the ends of a closed boundary; beyond the key
    /// points of an open one, that of the nearest.</summary>
    public double At(int vertex, Func<DrawnPoint, double> deviation)
    {
        var station = _outline.StationOf(vertex);
        var next = Array.FindIndex(_stations, s => s.Station >= station);
        if (next <= 0 && IsClosed)
        {
            var (last, first, length) = (_stations[^1], _stations[0], _outline.StationOf(Segments));
            var beyond = station < last.Station ? station + length - last.Station : station - last.Station;
            return deviation(last.Point)
                + ((deviation(first.Point) - deviation(last.Point)) * beyond / (first.Station + length - last.Station));
        }

        if (next <= 0)
        {
            return deviation(_stations[next < 0 ? ^1 : 0].Point);
        }

        var (from, to) = (_stations[next - 1], _stations[next]);
        var fraction = (station - from.Station) / (to.Station - from.Station);
        return deviation(from.Point) + ((deviation(to.Point) - deviation(from.Point)) * fraction);
    }

    /// <summary>The boundary place nearest to a key point, where its deviation is drawn.</summary>
    public Point2 Foot(DrawnPoint point) => _outline.At(_outline.Nearest(point.At));

    // A key point and its place along the boundary.
    private sealed record PlacedPoint(double Station, DrawnPoint Point);
}
