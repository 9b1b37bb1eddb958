namespace ErrorMatching.Geometry;

/// <summary>Upper bounds of the lengths of a Bezier surface's derivatives, up to the third order, with respect to parameters from -1 to 1
/// over the surface.</summary>
/// <remarks>A polynomial is inside the hull of its poles, and the poles of its derivatives are differences of them. A rational surface S =
/// A / w is bounded by w S^(k,l) = A^(k,l) - sum C(k,i) C(l,j) w^(i,j) S^(k-i,l-j) (The NURBS Book, equation 4.20), after subtracting its
/// tangent plane at the middle so that all S on the right are small.</remarks>
internal sealed class DerivativeBounds
{
    private const int Orders = 4;

    private readonly double[] _length = new double[Orders * Orders];

    /// <summary>Calculates the bounds of a surface.</summary>
    /// <param name="piece">A surface without inner breaks.</param>
    /// <param name="center">The point at the middle of its parameters.</param>
    /// <param name="ds">First derivative there with respect to the first parameter, from -1 to 1.</param>
    /// <param name="dt">First derivative there with respect to the second parameter, from -1 to 1.</param>
    public DerivativeBounds(SplineSurface piece, Point3 center, Vector3 ds, Vector3 dt)
    {
        var (countU, countV) = (piece.CountU, piece.CountV);
        var values = Homogeneous(piece, center);
        var least = 1.0;
        if (piece.IsRational)
        {
            least = double.PositiveInfinity;
            foreach (var w in piece.Weights)
            {
                least = Math.Min(least, w);
            }

            values = WithoutPlane(values, countU, countV, ds, dt);
            (countU, countV) = (countU + 1, countV + 1);
        }

        Span<double> weight = stackalloc double[Orders * Orders];
        for (var k = 0; k < Math.Min(Orders, countU); k++)
        {
            var row = (double[])values.Clone();
            for (var l = 0; k + l < Orders && l < countV; l++)
            {
                (_length[(k * Orders) + l], weight[(k * Orders) + l]) = Largest(row, countU - k, countV - l, countV);
                Differentiate(row, countU - k, countV - l, countV, alongU: false);
            }

            Differentiate(values, countU - k, countV, countV, alongU: true);
        }

        if (piece.IsRational)
        {
            Project(weight, least);
            _length[Orders] += ds.Length;
            _length[1] += dt.Length;
        }
    }

    private DerivativeBounds()
    {
    }

    public static DerivativeBounds None { get; } = new();

    /// <summary>Bound of the derivative of order k in the first and l in the second parameter; k + l is at most 3.</summary>
    public double this[int k, int l] => _length[(k * Orders) + l];

    private static double[] Homogeneous(SplineSurface piece, Point3 near)
    {
        var values = new double[piece.Poles.Length * 4];
        for (var i = 0; i < piece.Poles.Length; i++)
        {
            var (seen, w) = (piece.Poles[i] - near, piece.IsRational ? piece.Weights[i] : 1);
            (values[4 * i], values[(4 * i) + 1], values[(4 * i) + 2], values[(4 * i) + 3]) = (seen.X * w, seen.Y * w, seen.Z * w, w);
        }

        return values;
    }

    /// <summary>The poles of A - w (s Ds + t Dt), which has one degree more in each direction. With the new degree n, w times s has the
    /// poles i / n w(i - 1) - (1 - i / n) w(i).</summary>
    private static double[] WithoutPlane(double[] values, int countU, int countV, Vector3 ds, Vector3 dt)
    {
        var raised = new double[(countU + 1) * (countV + 1) * 4];
        for (var i = 0; i <= countU; i++)
        {
            for (var j = 0; j <= countV; j++)
            {
                var target = raised.AsSpan(((i * (countV + 1)) + j) * 4, 4);
                for (var corner = 0; corner < 4; corner++)
                {
                    var (a, b) = (corner & 1, corner >> 1);
                    var (shareU, shareV) = ((double)i / countU, (double)j / countV);
                    var share = (a == 1 ? shareU : 1 - shareU) * (b == 1 ? shareV : 1 - shareV);
                    if (share == 0)
                    {
                        continue;
                    }

                    var source = values.AsSpan((((i - a) * countV) + j - b) * 4, 4);
                    var plane = (ds * (a == 1 ? 1 : -1)) + (dt * (b == 1 ? 1 : -1));
                    target[0] += share * (source[0] - (source[3] * plane.X));
                    target[1] += share * (source[1] - (source[3] * plane.Y));
                    target[2] += share * (source[2] - (source[3] * plane.Z));
                    target[3] += share * source[3];
                }
            }
        }

        return raised;
    }

    private static (double Length, double Weight) Largest(double[] values, int countU, int countV, int stride)
    {
        var (length, weight) = (0.0, 0.0);
        for (var i = 0; i < countU; i++)
        {
            for (var j = 0; j < countV; j++)
            {
                var v = values.AsSpan(((i * stride) + j) * 4, 4);
                length = Math.Max(length, new Vector3(v[0], v[1], v[2]).Length);
                weight = Math.Max(weight, Math.Abs(v[3]));
            }
        }

        return (length, weight);
    }

    /// <summary>Replaces poles by those of the derivative: half of its value over 0 to 1.</summary>
    private static void Differentiate(double[] values, int countU, int countV, int stride, bool alongU)
    {
        var factor = 0.5 * ((alongU ? countU : countV) - 1);
        var (rows, columns, next) = alongU ? (countU - 1, countV, stride * 4) : (countU, countV - 1, 4);
        for (var i = 0; i < rows; i++)
        {
            for (var j = 0; j < columns; j++)
            {
                for (var c = 0; c < 4; c++)
                {
                    var at = (((i * stride) + j) * 4) + c;
                    values[at] = factor * (values[at + next] - values[at]);
                }
            }
        }
    }

    private void Project(ReadOnlySpan<double> weight, double least)
    {
        for (var k = 0; k < Orders; k++)
        {
            for (var l = 0; k + l < Orders; l++)
            {
                var sum = _length[(k * Orders) + l];
                for (var i = 0; i <= k; i++)
                {
                    for (var j = 0; j <= l; j++)
                    {
                        sum += i + j == 0
                            ? 0
                            : Binomial(k, i) * Binomial(l, j) * weight[(i * Orders) + j] * _length[((k - i) * Orders) + l - j];
                    }
                }

                _length[(k * Orders) + l] = sum / least;
            }
        }
    }

    private static int Binomial(int n, int k) => k == 0 || k == n ? 1 : n;
}
