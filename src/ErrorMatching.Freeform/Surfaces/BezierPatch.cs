using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>One polynomial or rational piece of a surface, bounded by its poles: it is inside their convex hull (The NURBS Book, P1.9 and
/// section 4.4).</summary>
internal sealed class BezierPatch
{
    // x w, y w, z w, w of each pole, v varying fastest.
    private readonly double[] _weighted;

    // x of all poles, then y, then z. The last pole is repeated to a multiple of four.
    private readonly double[] _poles;
    private readonly int _padded;
    private readonly int _rows;
    private readonly int _columns;

    private BezierPatch(double[] weighted, int rows, int columns, Point2 from, Point2 to)
    {
        (_weighted, _rows, _columns, From, To) = (weighted, rows, columns, from, to);
        var count = rows * columns;
        _padded = (count + Vector256<double>.Count - 1) / Vector256<double>.Count * Vector256<double>.Count;
        _poles = new double[3 * _padded];
        var (minX, minY, minZ) = (double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity);
        var (maxX, maxY, maxZ) = (double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity);
        for (var i = 0; i < _padded; i++)
        {
            var number = 4 * Math.Min(i, count - 1);
            var w = 1 / weighted[number + 3];
            var (x, y, z) = (weighted[number] * w, weighted[number + 1] * w, weighted[number + 2] * w);
            (_poles[i], _poles[_padded + i], _poles[(2 * _padded) + i]) = (x, y, z);
            (minX, minY, minZ) = (Math.Min(minX, x), Math.Min(minY, y), Math.Min(minZ, z));
            (maxX, maxY, maxZ) = (Math.Max(maxX, x), Math.Max(maxY, y), Math.Max(maxZ, z));
        }

        var diagonal = new Vector3(maxX - minX, maxY - minY, maxZ - minZ);
        (Middle, Radius) = (new Point3(minX, minY, minZ) + (diagonal * 0.5), diagonal.Length / 2);
        (Lowest, Highest) = (minZ, maxZ);
    }

    public Point2 From { get; }

    public Point2 To { get; }

    /// <summary>Center of a ball that contains the patch.</summary>
    public Point3 Middle { get; }

    public double Radius { get; }

    /// <summary>A lower bound of the patch's height.</summary>
    public double Lowest { get; }

    /// <summary>An upper bound of the patch's height.</summary>
    public double Highest { get; }

    public static IEnumerable<BezierPatch> Of(SplineSurface surface)
    {
        foreach (var piece in surface.Pieces())
        {
            var values = new double[4 * piece.Poles.Length];
            for (var i = 0; i < piece.Poles.Length; i++)
            {
                var (pole, weight) = (piece.Poles[i], piece.IsRational ? piece.Weights[i] : 1);
                (
                    values[4 * i],
                    values[(4 * i) + 1],
                    values[(4 * i) + 2],
                    values[(4 * i) + 3]) = (pole.X * weight, pole.Y * weight, pole.Z * weight, weight);
            }

            yield return new(
                values, piece.CountU, piece.CountV, new(piece.KnotsU.Start, piece.KnotsV.Start), new(piece.KnotsU.End, piece.KnotsV.End));
        }
    }

    /// <summary>True if no place of the patch is nearer to a point than a distance, because the patch is beyond a plane across the
    /// direction, or laterally distant from the point, or both. In the direction of the normal at its foot, a point over a convex surface
    /// is as far from this plane as from the surface, however large the patch is.</summary>
    /// <param name="point">The point.</param>
    /// <param name="direction">A unit direction from the surface to the point.</param>
    /// <param name="distance">The distance.</param>
    public bool IsBeyond(Point3 point, Vector3 direction, double distance)
    {
        var to = point - Middle;
        var along = to.Dot(direction);
        var beside = Math.Max(0, Math.Sqrt(Math.Max(0, to.Dot(to) - (along * along))) - Radius);
        var over = Math.Max(0, along - HighestAlong(direction));
        return (over * over) + (beside * beside) >= distance * distance;
    }

    /// <summary>The same for all points of a straight way.</summary>
    public bool IsBeyond(Point3 from, Point3 to, Vector3 direction, double distance) =>
        Math.Min((from - Middle).Dot(direction), (to - Middle).Dot(direction)) - HighestAlong(direction) >= distance;

    public bool HasCornerNearer(Point3 point, double distance)
    {
        var (row, column) = (_rows - 1, _columns - 1);
        return (point - At(0, 0)).Length < distance || (point - At(row, column)).Length < distance
            || (point - At(0, column)).Length < distance || (point - At(row, 0)).Length < distance;
    }

    /// <summary>The corners, which are on the surface.</summary>
    public IEnumerable<Point3> Corners => [At(0, 0), At(_rows - 1, _columns - 1), At(0, _columns - 1), At(_rows - 1, 0)];

    /// <summary>Splits the patch across its longer side (de Casteljau).</summary>
    public (BezierPatch First, BezierPatch Second) TwoThreads()
    {
        var (rows, columns) = (_rows - 1, _columns - 1);
        var alongU = (At(rows, 0) - At(0, 0)).Length + (At(rows, columns) - At(0, columns)).Length
            >= (At(0, columns) - At(0, 0)).Length + (At(rows, columns) - At(rows, 0)).Length;
        var (first, second) = ((double[])_weighted.Clone(), (double[])_weighted.Clone());
        var (count, stride, lines, lineStride) = alongU ? (_rows, 4 * _columns, _columns, 4) : (_columns, 4, _rows, 4 * _columns);
        for (var line = 0; line < lines; line++)
        {
            var start = line * lineStride;
            for (var level = 1; level < count; level++)
            {
                for (var i = 0; i < count - level; i++)
                {
                    for (var k = 0; k < 4; k++)
                    {
                        var at = start + (i * stride) + k;
                        second[at] = (second[at] + second[at + stride]) / 2;
                    }
                }

                Array.Copy(second, start, first, start + (level * stride), 4);
            }
        }

        var middle = From.Lerp(To, 0.5);
        return alongU
            ? (new(first, _rows, _columns, From, new(middle.X, To.Y)), new(second, _rows, _columns, new(middle.X, From.Y), To))
            : (new(first, _rows, _columns, From, new(To.X, middle.Y)), new(second, _rows, _columns, new(From.X, middle.Y), To));
    }

    // The largest extent of the poles along a direction, from the center.
    private double HighestAlong(Vector3 direction)
    {
        var middle = (Middle.X * direction.X) + (Middle.Y * direction.Y) + (Middle.Z * direction.Z);
        ref var poles = ref MemoryMarshal.GetArrayDataReference(_poles);
        var highest = Vector256.Create(double.NegativeInfinity);
        for (var i = 0; i < _padded; i += Vector256<double>.Count)
        {
            highest = Vector256.Max(
                highest,
                (Vector256.LoadUnsafe(ref poles, (nuint)i) * direction.X)
                    + (Vector256.LoadUnsafe(ref poles, (nuint)(_padded + i)) * direction.Y)
                    + (Vector256.LoadUnsafe(ref poles, (nuint)((2 * _padded) + i)) * direction.Z));
        }

        return Math.Max(Math.Max(highest[0], highest[1]), Math.Max(highest[2], highest[3])) - middle;
    }

    private Point3 At(int row, int column)
    {
        var i = (row * _columns) + column;
        return new(_poles[i], _poles[_padded + i], _poles[(2 * _padded) + i]);
    }
}
