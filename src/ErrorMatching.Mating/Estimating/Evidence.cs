using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>How well a normal distribution explains measured values.</summary>
/// <remarks>Rasmussen and Williams (2006), equation 2.30 and algorithm 2.1. Calculated in place, because a choice of priors asks it about a
/// hundred times for matrices of ten to twenty rows.</remarks>
internal static class Evidence
{
    /// <summary>Logarithm of the probability density of values, without its constant.</summary>
    /// <param name="covariance">Their covariance, row by row; its lower half is overwritten.</param>
    /// <param name="values">The values.</param>
    public static double Log(Span<double> covariance, ReadOnlySpan<double> values)
    {
        var n = values.Length;
        Span<double> solved = n <= 64 ? stackalloc double[n] : new double[n];
        var sum = 0.0;
        for (var i = 0; i < n; i++)
        {
            var row = covariance.Slice(i * n, i + 1);
            var value = values[i];
            for (var j = 0; j < i; j++)
            {
                var above = covariance.Slice(j * n, j + 1);
                var rest = row[j];
                for (var k = 0; k < j; k++)
                {
                    rest -= row[k] * above[k];
                }

                row[j] = rest / above[j];
                value -= row[j] * solved[j];
            }

            var pivot = row[i];
            for (var k = 0; k < i; k++)
            {
                pivot -= row[k] * row[k];
            }

            row[i] = Math.Sqrt(Math.Max(pivot, double.Epsilon));
            solved[i] = value / row[i];
            sum += (solved[i] * solved[i]) + (2 * Elementary.Log(row[i]));
        }

        return -sum / 2;
    }
}
