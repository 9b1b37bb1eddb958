using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A feature in a drawing of the assembly: a boundary, and deviations from it at its key points, between which they change evenly along it.</summary>
internal sealed class DrawnFeature
{
    private readonly DrawnOutline outline;
    private readonly int side;
    private readonly (double Station, DrawnPoint Point)[] stations;

    private DrawnFeature(DrawnOutline outline, IReadOnlyList<DrawnPoint> points)
    {
        Points = points;
        stations = [.. points.Select(p => (Station: outline.Nearest(p.At), Point: p)).OrderBy(s => s.Station)];

        // A deviation bends where it is known, so each key point becomes a vertex.
        this.outline = outline.WithVertices(stations.Select(s => s.Station));
        var sides = stations.Sum(s => this.outline.Left(this.outline.SegmentAt(s.Station)).Dot(s.Point.Normal));
        side = sides < 0 ? -1 : 1;
    }

    /// <summary>Its key points.</summary>
    public IReadOnlyList<DrawnPoint> Points { get; }

    /// <summary>Number of straight pieces of its boundary.</summary>
    public int Segments => outline.Segments;

    /// <summary>Where the boundary begins.</summary>
    public Point2 Start => outline.Vertex(0);

    /// <summary>Where it ends.</summary>
    public Point2 End => outline.Vertex(Segments);

    /// <summary>A feature, or null if fewer than two places of it are known. Without an outline its key points are one.</summary>
    public static DrawnFeature? Of(IReadOnlyList<Point2> outline, IReadOnlyList<DrawnPoint> points) =>
        points.Count > 0 && DrawnOutline.Of(outline.Count >= 2 ? outline : [.. points.Select(p => p.At)]) is { } drawn ? new(drawn, points) : null;

    /// <summary>A vertex of the boundary.</summary>
    public Point2 Vertex(int index) => outline.Vertex(index);

    /// <summary>Unit normal of a piece, into the part.</summary>
    public Vector2 Normal(int segment) => outline.Left(segment) * side;

    /// <summary>A deviation at a vertex: even between the key points, that of the nearest key point beyond them.</summary>
    public double At(int vertex, Func<DrawnPoint, double> deviation)
    {
        var station = outline.StationOf(vertex);
        var next = Array.FindIndex(stations, s => s.Station >= station);
        if (next <= 0)
        {
            return deviation(stations[next < 0 ? ^1 : 0].Point);
        }

        var (from, to) = (stations[next - 1], stations[next]);
        var fraction = (station - from.Station) / (to.Station - from.Station);
        return deviation(from.Point) + ((deviation(to.Point) - deviation(from.Point)) * fraction);
    }

    /// <summary>The place of the boundary nearest to a key point, where its deviation is drawn.</summary>
    public Point2 Foot(DrawnPoint point) => outline.At(outline.Nearest(point.At));
}
