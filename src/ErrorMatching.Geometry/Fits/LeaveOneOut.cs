namespace ErrorMatching.Geometry;

/// <summary>Leave-one-out errors of every degree and ridge weight in closed form, and the selection based on them.</summary>
/// <remarks>A linear smoother with hat matrix H, whose penalty does not change when a point is left out, misses that point by <c>r[i] / (1
/// - h[i,i])</c>. In the orthonormal basis q, the hat matrix is the sum of <c>s[k] q[k] q[k]^T</c> with <c>s[k] = 1 / (1 + weight k^4)</c>,
/// so one pass gives all errors.</remarks>
internal sealed class LeaveOneOut
{
    /// <summary>A point with a leverage this close to 1 determines its own value: the fit without it is undetermined.</summary>
    private const double FullLeverage = 1 - 1e-9;

    /// <summary>A more complex fit must be better by more than this share.</summary>
    private const double Improvement = 1e-6;

    /// <summary>Leave-one-out errors below this share of the largest ordinate are rounding errors: the fit is exact.</summary>
    private const double Exact = 1e-14;

    private readonly double[][] _leverages;
    private readonly double[][] _fitted;
    private readonly double[][] _residuals;

    public LeaveOneOut(ForsytheBasis basis)
    {
        _leverages = [.. basis.Values.Select((row, k) => Array.ConvertAll(row, v => (v * v / basis.SquaredNorms[k]).ToDouble()))];
        _fitted = [.. basis.Values.Select((row, k) => Array.ConvertAll(row, v => (v * basis.Coefficients[k]).ToDouble()))];
        _residuals = [.. basis.Residuals.Select(row => Array.ConvertAll(row, v => v.ToDouble()))];
    }

    /// <summary>Share of the plain coefficient of degree k that remains after applying a ridge weight.</summary>
    public static double Shrink(int k, double ridge) => 1 / (1 + (ridge * ((double)k * k * k * k)));

    /// <summary>The weights tried for an automatic ridge: 0, and 10^-6 to 1 in half decades.</summary>
    public static double[] Grid() => [0, .. Enumerable.Range(0, 13).Select(i => Elementary.Pow(10, -6 + (i / 2.0)))];

    /// <summary>Root mean square of the leave-one-out errors; null if a point determines its own value.</summary>
    public double? Rms(int degree, double ridge)
    {
        Span<double> kept = stackalloc double[degree + 1];
        for (var k = 0; k <= degree; k++)
        {
            kept[k] = Shrink(k, ridge);
        }

        var sum = 0.0;
        var n = _residuals[degree].Length;
        for (var i = 0; i < n; i++)
        {
            var (leverage, residual) = (0.0, _residuals[degree][i]);
            for (var k = 0; k <= degree; k++)
            {
                leverage += kept[k] * _leverages[k][i];
                residual += (1 - kept[k]) * _fitted[k][i];
            }

            if (leverage > FullLeverage)
            {
                return null;
            }

            var missed = residual / (1 - leverage);
            sum += missed * missed;
        }

        return Math.Sqrt(sum / n);
    }

    /// <summary>Selects the pair with the lowest leave-one-out error. Ties within 1e-6, and fits after one that is exact to rounding, go to
    /// the lower degree, then to the earlier weight. If no pair can be judged (a single point), the lowest degree is selected.</summary>
    public (int Degree, double Ridge) Choose(IEnumerable<int> degrees, IReadOnlyList<double> ridges, double largest)
    {
        (int Degree, double Ridge)? chosen = null;
        var best = double.PositiveInfinity;
        foreach (var degree in degrees)
        {
            chosen ??= (degree, ridges[0]);
            foreach (var ridge in ridges)
            {
                if (best > Exact * largest && Rms(degree, ridge) is { } rms && rms < best * (1 - Improvement))
                {
                    (chosen, best) = ((degree, ridge), rms);
                }
            }
        }

        return chosen!.Value;
    }
}
