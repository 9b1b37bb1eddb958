namespace ErrorMatching.Geometry;

/// <summary>
/// Lengths that the derivatives of a Bezier surface do not exceed, up to the third order, by parameters that run from -1 to 1 over the surface.
/// </summary>
/// <remarks>
/// A polynomial lies in the hull of its poles, and the poles of its derivatives are differences of them. A rational surface S = A / w is bounded through
/// w S^(k,l) = A^(k,l) - sum C(k,i) C(l,j) w^(i,j) S^(k-i,l-j) (The NURBS Book, equation 4.20), seen from a point near it, so that A is small.
/// </remarks>
internal sealed class DerivativeBounds
{
    private const int Orders = 4;

    private readonly double[] _length = new double[Orders * Orders];

    /// <summary>Bounds of a surface.</summary>
    /// <param name="piece">A surface without inner breaks.</param>
    /// <param name="near">A point near it, from which the poles are seen.</param>
    public DerivativeBounds(SplineSurface piece, Point3 near)
    {
        var (p, q) = (piece.KnotsU.Degree, piece.KnotsV.Degree);
        var values = Homogeneous(piece, near);
        Span<double> weight = stackalloc double[Orders * Orders];
        var least = double.PositiveInfinity;
        for (var i = 3; i < values.Length; i += 4)
        {
            least = Math.Min(least, values[i]);
        }

        for (var k = 0; k < Orders; k++)
        {
            var row = (double[])values.Clone();
            for (var l = 0; k + l < Orders; l++)
            {
                (_length[(k * Orders) + l], weight[(k * Orders) + l]) = k > p || l > q ? (0, 0) : Largest(row, p + 1 - k, q + 1 - l, q + 1);
                Differentiate(row, p + 1 - k, q + 1 - l, q + 1, alongU: false);
            }

            Differentiate(values, p + 1 - k, q + 1, q + 1, alongU: true);
        }

        Project(weight, least);
    }

    private DerivativeBounds()
    {
    }

    /// <summary>No bounds at all.</summary>
    public static DerivativeBounds None { get; } = new();

    /// <summary>A length that the derivative of order k by the first and l by the second parameter does not exceed; k + l is at most 3.</summary>
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

    /// <summary>Poles of the derivative in place of the poles; half of what it is over 0 to 1.</summary>
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
                        sum += i + j == 0 ? 0 : Binomial(k, i) * Binomial(l, j) * weight[(i * Orders) + j] * _length[((k - i) * Orders) + l - j];
                    }
                }

                _length[(k * Orders) + l] = sum / least;
            }
        }
    }

    private static int Binomial(int n, int k) => k == 0 || k == n ? 1 : n;
}
