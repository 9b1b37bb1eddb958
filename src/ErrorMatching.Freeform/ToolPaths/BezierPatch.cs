using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>One polynomial or rational piece of a surface by its poles, which hold it: it lies in their hull (The NURBS Book, P1.9 and section 4.4).</summary>
internal sealed class BezierPatch
{
    // x w, y w, z w, w of each pole, v running faster.
    private readonly double[] _poles;
    private readonly int _rows;
    private readonly int _columns;

    private BezierPatch(double[] poles, int rows, int columns, Point2 from, Point2 to)
    {
        (_poles, _rows, _columns, From, To) = (poles, rows, columns, from, to);
        Box = Box3.Around(Points());
        var (a, b) = (At(rows - 1, columns - 1) - At(0, 0), At(0, columns - 1) - At(rows - 1, 0));
        var cross = a.Cross(b);
        var length = cross.Length;
        Direction = length > 0 ? cross * (1 / length) : new(0, 0, 1);
        (Low, High) = (double.PositiveInfinity, double.NegativeInfinity);
        for (var i = 0; i < _poles.Length; i += 4)
        {
            var height = ((_poles[i] * Direction.X) + (_poles[i + 1] * Direction.Y) + (_poles[i + 2] * Direction.Z)) / _poles[i + 3];
            (Low, High) = (Math.Min(Low, height), Math.Max(High, height));
        }
    }

    /// <summary>First pair of parameters.</summary>
    public Point2 From { get; }

    /// <summary>Last pair of parameters.</summary>
    public Point2 To { get; }

    /// <summary>A box around the poles.</summary>
    public Box3 Box { get; }

    /// <summary>A unit direction across the patch.</summary>
    public Vector3 Direction { get; }

    /// <summary>The patch lies between two planes: from here along <see cref="Direction"/>.</summary>
    public double Low { get; }

    /// <summary>To here.</summary>
    public double High { get; }

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

    /// <summary>A distance from a point that no place of the patch falls below.</summary>
    public double LeastDistance(Point3 p)
    {
        var height = (p.X * Direction.X) + (p.Y * Direction.Y) + (p.Z * Direction.Z);
        return Math.Max(Box.DistanceTo(p), Math.Max(height - High, Low - height));
    }

    /// <summary>The smallest distance of a point from a corner of the patch.</summary>
    public double CornerDistance(Point3 p) => Math.Min(
        Math.Min((p - At(0, 0)).Length, (p - At(0, _columns - 1)).Length), Math.Min((p - At(_rows - 1, 0)).Length, (p - At(_rows - 1, _columns - 1)).Length));

    /// <summary>Both halves, cut across the longer side (de Casteljau).</summary>
    public (BezierPatch First, BezierPatch Second) Halves()
    {
        var alongU = (At(_rows - 1, 0) - At(0, 0)).Length + (At(_rows - 1, _columns - 1) - At(0, _columns - 1)).Length
            >= (At(0, _columns - 1) - At(0, 0)).Length + (At(_rows - 1, _columns - 1) - At(_rows - 1, 0)).Length;
        var (first, second) = ((double[])_poles.Clone(), (double[])_poles.Clone());
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

    private Point3 At(int row, int column)
    {
        var i = 4 * ((row * _columns) + column);
        return new(_poles[i] / _poles[i + 3], _poles[i + 1] / _poles[i + 3], _poles[i + 2] / _poles[i + 3]);
    }

    private Point3[] Points()
    {
        var points = new Point3[_rows * _columns];
        for (var i = 0; i < points.Length; i++)
        {
            points[i] = At(i / _columns, i % _columns);
        }

        return points;
    }
}
