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

    // Unit direction and length of the piece that ends at each point.
    private Vector3[] _along = new Vector3[64];
    private double[] _lengths = new double[64];

    public int Count { get; private set; }

    public ReadOnlySpan<Point2> Places => _places.AsSpan(0, Count);

    public ReadOnlySpan<Point3> Centers => _centers.AsSpan(0, Count);

    public ReadOnlySpan<Vector3> Normals => _normals.AsSpan(0, Count);

    /// <summary>By how much centers were raised where the ball would have cut elsewhere, in millimetres.</summary>
    public ReadOnlySpan<double> Raised => _raised.AsSpan(0, Count);

    /// <summary>The straight piece that begins at a point: its ends, its unit direction (zero if it has no length) and its length.</summary>
    public CenterPiece Piece(int from) => new(_centers[from], _centers[from + 1], _along[from + 1], _lengths[from + 1]);

    /// <summary>True if one of the ends of a piece was raised.</summary>
    public bool IsRaised(int from) => _raised[from] > 0 || _raised[from + 1] > 0;

    /// <summary>True if the line passes a parameter u, rising from its beginning.</summary>
    public bool Covers(double u) => Count > 1 && _places[0].X <= u && u <= _places[Count - 1].X;

    public void Clear() => Count = 0;

    public void Add(Point2 place, Point3 center, Vector3 normal, double raised = 0)
    {
        if (Count == _places.Length)
        {
            Array.Resize(ref _places, 2 * Count);
            Array.Resize(ref _centers, 2 * Count);
            Array.Resize(ref _normals, 2 * Count);
            Array.Resize(ref _raised, 2 * Count);
            Array.Resize(ref _along, 2 * Count);
            Array.Resize(ref _lengths, 2 * Count);
        }

        (_places[Count], _centers[Count], _normals[Count], _raised[Count]) = (place, center, normal, raised);
        if (Count > 0)
        {
            var along = center - _centers[Count - 1];
            var length = along.Length;
            (_along[Count], _lengths[Count]) = (along * (length > 0 ? 1 / length : 0), length);
        }

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
            var along = _along[i + 1];
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
