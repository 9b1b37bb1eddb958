namespace ErrorMatching.Freeform;

/// <summary>Clamped cubic B-splines on an axis from -1 to 1 (Piegl and Tiller, The NURBS Book, 2nd edition, algorithm A2.2).</summary>
internal sealed class SplineAxis
{
    private readonly double[] _breaks;
    private readonly double[] _knots;

    private SplineAxis(double[] breaks)
    {
        _breaks = breaks;
        _knots = [breaks[0], breaks[0], breaks[0], .. breaks, breaks[^1], breaks[^1], breaks[^1]];
    }

    public int Count => _breaks.Length + 2;

    /// <summary>Where the pieces meet, including both ends.</summary>
    public ReadOnlySpan<double> Breaks => _breaks;

    /// <summary>Creates an axis with one piece per line interval, or per several intervals if there are many lines.</summary>
    public static SplineAxis Over(double[] lines, int mostPieces)
    {
        var pieces = Math.Min(lines.Length - 1, mostPieces);
        var inner = Enumerable.Range(1, pieces - 1)
            .Select(k => lines[(int)((long)k * (lines.Length - 1) / pieces)])
            .Where(t => t is > -1 and < 1)
            .Distinct();
        return new([-1, .. inner, 1]);
    }

    /// <summary>The four nonzero B-splines at a place, and the index of the first.</summary>
    public (int First, double[] Values) At(double t)
    {
        var (span, values) = Basis(t, 3);
        return (span - 3, values);
    }

    /// <summary>The integrals of the products of derivatives of each pair of B-splines, by four-point Gauss quadrature on each piece:
    /// exact for cubics.</summary>
    public double[][] Products(int order)
    {
        var result = Array.ConvertAll(new double[Count][], _ => new double[Count]);
        ReadOnlySpan<double> nodes = [-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526];
        ReadOnlySpan<double> weights = [0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538];
        for (var piece = 0; piece + 1 < _breaks.Length; piece++)
        {
            var half = (_breaks[piece + 1] - _breaks[piece]) / 2;
            for (var k = 0; k < 4; k++)
            {
                var (first, values) = Derivatives(_breaks[piece] + (half * (1 + nodes[k])), order);
                for (var i = 0; i < 4; i++)
                {
                    for (var j = 0; j < 4; j++)
                    {
                        result[first + i][first + j] += half * weights[k] * values[i] * values[j];
                    }
                }
            }
        }

        return result;
    }

    /// <summary>Derivatives as differences of the B-splines of lower degree (The NURBS Book, equation 2.7).</summary>
    private (int First, double[] Values) Derivatives(double t, int order)
    {
        var (span, values) = Basis(t, 3 - order);
        for (var degree = 4 - order; degree <= 3; degree++)
        {
            var next = new double[degree + 1];
            for (var k = 0; k <= degree; k++)
            {
                var i = span - degree + k;
                var left = k > 0 ? values[k - 1] / (_knots[i + degree] - _knots[i]) : 0;
                var right = k < degree ? values[k] / (_knots[i + degree + 1] - _knots[i + 1]) : 0;
                next[k] = degree * (left - right);
            }

            values = next;
        }

        return (span - 3, values);
    }

    private (int Span, double[] Values) Basis(double t, int degree)
    {
        var piece = Array.BinarySearch(_breaks, t);
        piece = Math.Clamp(piece >= 0 ? piece : ~piece - 1, 0, _breaks.Length - 2);
        var span = piece + 3;
        var values = new double[degree + 1];
        values[0] = 1;
        for (var j = 1; j <= degree; j++)
        {
            var saved = 0.0;
            for (var r = 0; r < j; r++)
            {
                var (left, right) = (_knots[span + 1 - j + r], _knots[span + r + 1]);
                var part = values[r] / (right - left);
                values[r] = saved + ((right - t) * part);
                saved = (t - left) * part;
            }

            values[j] = saved;
        }

        return (span, values);
    }
}
