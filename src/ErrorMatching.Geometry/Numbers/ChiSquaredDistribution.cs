namespace ErrorMatching.Geometry;

/// <summary>The distribution of the sum of squares of independent standard normal values, the same on every system.</summary>
public static class ChiSquaredDistribution
{
    // A term that becomes larger is made smaller by it, with the sum.
    private const double Step = 1e100, LogOfStep = 230.25850929940457;

    /// <summary>The probability that a sum of squares is above x, to 12 digits.</summary>
    /// <remarks>With y = x/2, for an even number n of values exp(-y) (1 + y + y^2/2! + ...), up to the power n/2 - 1; for an odd number
    /// likewise with half powers, after the probability of one value (Abramowitz and Stegun, 26.4.4 and 26.4.5).</remarks>
    /// <param name="x">The sum of squares, 0 or more.</param>
    /// <param name="values">How many values are squared, 1 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException">The sum or the number is below its range.</exception>
    public static double Above(double x, int values)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(values, 1);
        if (!(x >= 0))
        {
            throw new ArgumentOutOfRangeException(nameof(x), x, "A sum of squares is 0 or more.");
        }

        var isOdd = values % 2 == 1;
        var (y, sum, logScale) = (x / 2, 0.0, -x / 2);
        var (term, power) = isOdd ? (2 * Math.Sqrt(y / Math.PI), 0.5) : (1, 0);
        for (var i = values / 2; i > 0; i--)
        {
            sum += term;
            power++;
            term *= y / power;
            if (term > Step)
            {
                (term, sum, logScale) = (term / Step, sum / Step, logScale + LogOfStep);
            }
        }

        return (isOdd ? 2 * NormalDistribution.Below(-Math.Sqrt(x)) : 0) + (sum * Elementary.Exp(logScale));
    }
}
