using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>How well a normal distribution explains measured values.</summary>
/// <remarks>Rasmussen and Williams (2006), equation 2.30 and algorithm 2.1.</remarks>
internal static class Evidence
{
    /// <summary>Logarithm of the probability density of values, without its constant; minus infinity for a covariance that is singular to
    /// rounding.</summary>
    /// <param name="covariance">Their covariance, row by row; its lower half is overwritten, because a choice of priors asks about a
    /// hundred times for matrices of ten to twenty rows.</param>
    /// <param name="values">The values.</param>
    public static double Log(double[] covariance, double[] values) =>
        Cholesky.Factor(covariance, values.Length) is { } factor ? Log(factor, values) : double.NegativeInfinity;

    /// <summary>The same from the factor of the covariance.</summary>
    public static double Log(Cholesky factor, double[] values)
    {
        double[] solved = [.. values];
        factor.Forward(solved);
        var sum = 0.0;
        for (var i = 0; i < solved.Length; i++)
        {
            sum += (solved[i] * solved[i]) + (2 * Elementary.Log(factor.Pivot(i)));
        }

        return -sum / 2;
    }
}
