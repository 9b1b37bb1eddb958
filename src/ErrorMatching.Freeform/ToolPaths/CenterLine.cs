using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A polyline of centers as rounded in the program, each with its place on the surface. Its memory is reused.</summary>
internal sealed class CenterLine
{
    private Point2[] _places = new Point2[64];
    private Point3[] _centers = new Point3[64];
    private Vector3[] _normals = new Vector3[64];
    private double[] _raised = new double[64];

    // Unit direction and length of the segment that ends at each point.
    private Vector3[] _along = new Vector3[64];
    private double[] _lengths = new double[64];

    public int Count { get; private set; }

    public ReadOnlySpan<Point2> Places => _places.AsSpan(0, Count);

    public ReadOnlySpan<Point3> Centers => _centers.AsSpan(0, Count);

    public ReadOnlySpan<Vector3> Normals => _normals.AsSpan(0, Count);

    /// <summary>How far centers were raised to avoid gouges, in millimeters.</summary>
    public ReadOnlySpan<double> Raised => _raised.AsSpan(0, Count);

    /// <summary>The segment that starts at a point: its ends, its unit direction (zero if it has no length) and its length.</summary>
    public CenterPiece Piece(int from) => new(_centers[from], _centers[from + 1], _along[from + 1], _lengths[from + 1]);

    public bool IsRaised(int from) => _raised[from] > 0 || _raised[from + 1] > 0;

    /// <summary>True if the line, with u ascending, covers a parameter u.</summary>
    public bool Covers(double u) => Count > 1 && _places[0].X <= u && u <= _places[Count - 1].X;

    /// <summary>The segment of a line along u that contains a parameter, or the first or last one; searched from a given one.</summary>
    public int PieceAt(double u, int piece)
    {
        var places = Places;
        while (piece + 2 < places.Length && places[piece + 1].X <= u)
        {
            piece++;
        }

        while (piece > 0 && places[piece].X > u)
        {
            piece--;
        }

        return piece;
    }

    public bool HasRaised { get; private set; }

    /// <summary>Four segments by their start indices: start points as vectors from the origin, unit directions and lengths.</summary>
    public void Pieces(
        int first, int second, int third, int fourth, out FourVectors from, out FourVectors along, out Vector256<double> lengthMm)
    {
        from = FourVectors.Of(Beginning(first), Beginning(second), Beginning(third), Beginning(fourth));
        along = FourVectors.Of(_along[first + 1], _along[second + 1], _along[third + 1], _along[fourth + 1]);
        lengthMm = Vector256.Create(_lengths[first + 1], _lengths[second + 1], _lengths[third + 1], _lengths[fourth + 1]);

        Vector3 Beginning(int i) => new(_centers[i].X, _centers[i].Y, _centers[i].Z);
    }

    public void Clear() => (Count, HasRaised) = (0, false);

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

        HasRaised |= raised > 0;
        Count++;
    }

    /// <summary>The last result of <see cref="MeasureChord"/>.</summary>
    public (double Mm, Point2 Place) Chord { get; private set; }

    /// <summary>Measures the largest distance of the exact curve from the polyline, sampled at every point and three times between two.
    /// Segments with raised points are skipped.</summary>
    public (double Mm, Point2 Place) MeasureChord(OffsetSurface offset)
    {
        var (largest, where) = (0.0, Count > 0 ? _places[0] : default);
        for (var i = 0; i + 1 < Count && !double.IsNaN(largest); i++)
        {
            var along = _along[i + 1];
            if (_places[i].Y == _places[i + 1].Y && Vector256.LessThanOrEqualAll(Off(i, offset), Vector256.Create(largest)))
            {
                continue;
            }

            for (var k = 0; k < Vector256<double>.Count; k++)
            {
                var place = _places[i].Lerp(_places[i + 1], Samples[k]);
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

    // The sampled positions along a segment.
    private static Vector256<double> Samples => Vector256.Create(0, 0.25, 0.5, 0.75);

    // All samples of a segment along a surface line at once; NaN if one has no normal.
    private Vector256<double> Off(int i, OffsetSurface offset)
    {
        var (from, to) = (_places[i], _places[i + 1]);
        if (!offset.Left(Vector256.Create(from.X) + (Samples * (to.X - from.X)), from.Y, out var places, out var normals))
        {
            return Vector256.Create(double.NaN);
        }

        var off = places + (normals * Vector256.Create(offset.RadiusMm)) - FourVectors.Of(new(_centers[i].X, _centers[i].Y, _centers[i].Z));
        var forward = off.Dot(FourVectors.Of(_along[i + 1]));
        return Vector256.Sqrt(Vector256.Max(Vector256<double>.Zero, off.Dot(off) - (forward * forward)));
    }
}

/// <summary>A straight segment of the path of the ball's center.</summary>
/// <param name="From">Its start.</param>
/// <param name="To">Its end.</param>
/// <param name="Along">Its unit direction; zero if both ends coincide.</param>
/// <param name="LengthMm">Its length.</param>
internal readonly record struct CenterPiece(Point3 From, Point3 To, Vector3 Along, double LengthMm);
