using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A polyline of centers as a program states them, each with its place on the surface. Made again and again without new memory.</summary>
internal sealed class CenterLine
{
    private static readonly double[] Samples = [0, 0.25, 0.5, 0.75];

    private Point2[] _places = new Point2[64];
    private Point3[] _centers = new Point3[64];
    private Vector3[] _normals = new Vector3[64];
    private double[] _raised = new double[64];

    public int Count { get; private set; }

    public ReadOnlySpan<Point2> Places => _places.AsSpan(0, Count);

    public ReadOnlySpan<Point3> Centers => _centers.AsSpan(0, Count);

    public ReadOnlySpan<Vector3> Normals => _normals.AsSpan(0, Count);

    /// <summary>By how much centers were raised where the ball would have cut elsewhere, in millimetres.</summary>
    public ReadOnlySpan<double> Raised => _raised.AsSpan(0, Count);

    public void Clear() => Count = 0;

    public void Add(Point2 place, Point3 center, Vector3 normal, double raised = 0)
    {
        if (Count == _places.Length)
        {
            Array.Resize(ref _places, 2 * Count);
            Array.Resize(ref _centers, 2 * Count);
            Array.Resize(ref _normals, 2 * Count);
            Array.Resize(ref _raised, 2 * Count);
        }

        (_places[Count], _centers[Count], _normals[Count], _raised[Count]) = (place, center, normal, raised);
        Count++;
    }

    /// <summary>What <see cref="MeasureChord"/> found last.</summary>
    public (double Mm, Point2 Place) Chord { get; private set; }

    /// <summary>The largest distance of the exact curve from the polyline, sampled at every point and three times between two; where points were raised on purpose, nothing is measured.</summary>
    public (double Mm, Point2 Place) MeasureChord(OffsetSurface offset)
    {
        var (largest, where) = (0.0, Count > 0 ? _places[0] : default);
        for (var i = 0; i + 1 < Count && !double.IsNaN(largest); i++)
        {
            var along = _centers[i + 1] - _centers[i];
            var length = along.Length;
            along *= length > 0 ? 1 / length : 0;
            foreach (var fraction in Samples)
            {
                var place = _places[i].Lerp(_places[i + 1], fraction);
                var off = CenterRounding.Across(offset.CenterAt(place.X, place.Y) - _centers[i], along);
                if (!(off <= largest) && _raised[i] == 0 && _raised[i + 1] == 0)
                {
                    (largest, where) = (off, place);
                }
            }
        }

        Chord = (largest, where);
        return Chord;
    }
}
