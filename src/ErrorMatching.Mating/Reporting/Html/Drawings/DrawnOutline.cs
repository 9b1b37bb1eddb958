using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A polyline cleaned up for drawing, with the length along it.</summary>
internal sealed class DrawnOutline
{
    // Vertices closer than this fraction of the size fall on one pixel.
    private const double Finest = 0.001;

    // The offset of a path steps back briefly where the path bends inward. Steps up to this fraction of the size are artifacts.
    private const double LongestStepBack = 0.02;

    private readonly Point2[] _vertices;
    private readonly double[] _stations;

    private DrawnOutline(Point2[] vertices)
    {
        _vertices = vertices;
        _stations = new double[vertices.Length];
        for (var i = 0; i < Segments; i++)
        {
            _stations[i + 1] = _stations[i] + vertices[i].DistanceTo(vertices[i + 1]);
        }
    }

    /// <summary>Number of straight pieces.</summary>
    public int Segments => _vertices.Length - 1;

    /// <summary>An outline, or null if its points coincide.</summary>
    public static DrawnOutline? Of(IReadOnlyList<Point2> places)
    {
        var size = new Point2(places.Min(p => p.X), places.Min(p => p.Y)).DistanceTo(new(places.Max(p => p.X), places.Max(p => p.Y)));
        var kept = new List<Point2>();
        foreach (var place in places)
        {
            if (kept.Count >= 2 && IsStepBack(kept[^2], kept[^1], place, size * LongestStepBack))
            {
                kept[^1] = kept[^1].Lerp(place, 0.5);
            }
            else if (kept.Count == 0 || kept[^1].DistanceTo(place) > size * Finest)
            {
                kept.Add(place);
            }
        }

        return kept.Count >= 2 ? new([.. kept]) : null;
    }

    /// <summary>A vertex.</summary>
    public Point2 Vertex(int index) => _vertices[index];

    /// <summary>Length along the outline to a vertex, mm.</summary>
    public double StationOf(int vertex) => _stations[vertex];

    /// <summary>Unit normal of a piece, to its left.</summary>
    public Vector2 Left(int segment) => (_vertices[segment + 1] - _vertices[segment]).Normalize().Left;

    /// <summary>The piece at a length along the outline.</summary>
    public int SegmentAt(double station) => Math.Clamp(Array.FindLastIndex(_stations, s => s <= station), 0, Segments - 1);

    /// <summary>The place at a length along the outline.</summary>
    public Point2 At(double station)
    {
        var i = SegmentAt(station);
        return _vertices[i].Lerp(_vertices[i + 1], (station - _stations[i]) / (_stations[i + 1] - _stations[i]));
    }

    /// <summary>Length along the outline to the place nearest to a point.</summary>
    public double Nearest(Point2 point)
    {
        var (best, distance) = (0.0, double.PositiveInfinity);
        for (var i = 0; i < Segments; i++)
        {
            var piece = new Segment2(_vertices[i], _vertices[i + 1]);
            var fraction = piece.NearestFraction(point);
            if (point.DistanceTo(piece.At(fraction)) is var found && found < distance)
            {
                (best, distance) = (_stations[i] + (fraction * (_stations[i + 1] - _stations[i])), found);
            }
        }

        return best;
    }

    /// <summary>The same outline with additional vertices at some lengths along it.</summary>
    public DrawnOutline WithVertices(IEnumerable<double> at)
    {
        var near = _stations[^1] * 1e-6;
        var all = _stations.ToList();
        foreach (var station in at)
        {
            if (all.TrueForAll(s => Math.Abs(s - station) > near))
            {
                all.Add(station);
            }
        }

        return new([.. all.Order().Select(At)]);
    }

    private static bool IsStepBack(Point2 from, Point2 last, Point2 next, double longest) =>
        (next - last).Dot(last - from) < 0 && (next - last).Length < longest;
}
