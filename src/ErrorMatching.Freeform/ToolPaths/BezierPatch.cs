using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>One polynomial or rational piece of a surface by its poles, which hold it: it lies in their hull (The NURBS Book, P1.9 and section 4.4).</summary>
internal sealed class BezierPatch
{
    // x w, y w, z w, w of each pole, v running faster.
    private readonly double[] _weighted;
    private readonly Point3[] _poles;
    private readonly int _rows;
    private readonly int _columns;

    private BezierPatch(double[] weighted, int rows, int columns, Point2 from, Point2 to)
    {
        (_weighted, _rows, _columns, From, To) = (weighted, rows, columns, from, to);
        _poles = new Point3[rows * columns];
        for (var i = 0; i < _poles.Length; i++)
        {
            var w = 1 / weighted[(4 * i) + 3];
            _poles[i] = new(weighted[4 * i] * w, weighted[(4 * i) + 1] * w, weighted[(4 * i) + 2] * w);
        }

        var box = Box3.Around(_poles);
        (Middle, Radius) = (box.Min + ((box.Max - box.Min) * 0.5), box.Diagonal / 2);
        (Lowest, Highest) = (box.Min.Z, box.Max.Z);
    }

    /// <summary>First pair of parameters.</summary>
    public Point2 From { get; }

    /// <summary>Last pair of parameters.</summary>
    public Point2 To { get; }

    /// <summary>The middle of a ball that holds the patch.</summary>
    public Point3 Middle { get; }

    /// <summary>Radius of that ball.</summary>
    public double Radius { get; }

    /// <summary>Height that the patch does not fall below.</summary>
    public double Lowest { get; }

    /// <summary>Height that the patch does not exceed.</summary>
    public double Highest { get; }

    /// <summary>The pieces of a surface.</summary>
    public static IEnumerable<BezierPatch> Of(SplineSurface surface)
    {
        foreach (var piece in surface.Pieces())
        {
            var values = new double[4 * piece.Poles.Length];
            for (var i = 0; i < piece.Poles.Length; i++)
            {
                var (pole, weight) = (piece.Poles[i], piece.IsRational ? piece.Weights[i] : 1);
                (values[4 * i], values[(4 * i) + 1], values[(4 * i) + 2], values[(4 * i) + 3]) = (pole.X * weight, pole.Y * weight, pole.Z * weight, weight);
            }

            yield return new(values, piece.CountU, piece.CountV, new(piece.KnotsU.Start, piece.KnotsV.Start), new(piece.KnotsU.End, piece.KnotsV.End));
        }
    }

    /// <summary>
    /// True if no place of the patch is nearer to a point than a distance: it lies beyond a plane across the direction, or beside the point, or both. Seen along the normal at its foot, a point over a convex surface is as far from that
    /// plane as from the surface, however large the patch.
    /// </summary>
    /// <param name="point">The point.</param>
    /// <param name="direction">A unit direction from the surface to the point.</param>
    /// <param name="distance">The distance.</param>
    public bool IsBeyond(Point3 point, Vector3 direction, double distance)
    {
        var to = point - Middle;
        var along = to.Dot(direction);
        var beside = Math.Max(0, Math.Sqrt(Math.Max(0, to.Dot(to) - (along * along))) - Radius);
        var highest = double.NegativeInfinity;
        foreach (var pole in _poles)
        {
            highest = Math.Max(highest, (pole - Middle).Dot(direction));
        }

        var over = Math.Max(0, along - highest);
        return (over * over) + (beside * beside) >= distance * distance;
    }

    /// <summary>True if a corner of the patch is nearer to a point than a distance.</summary>
    public bool HasCornerNearer(Point3 point, double distance) =>
        (point - _poles[0]).Length < distance || (point - _poles[^1]).Length < distance
        || (point - _poles[_columns - 1]).Length < distance || (point - _poles[^_columns]).Length < distance;

    /// <summary>The height of the highest corner.</summary>
    public double HighestCorner => Math.Max(Math.Max(_poles[0].Z, _poles[^1].Z), Math.Max(_poles[_columns - 1].Z, _poles[^_columns].Z));

    /// <summary>Both halves, cut across the longer side (de Casteljau).</summary>
    public (BezierPatch First, BezierPatch Second) Halves()
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

    private Point3 At(int row, int column) => _poles[(row * _columns) + column];
}
