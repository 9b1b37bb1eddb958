namespace ErrorMatching.Geometry;

/// <summary>The standard normal distribution, the same on every system.</summary>
public static class NormalDistribution
{
    // Nearer to the middle, the series is shorter than the continued fraction.
    private const double Tail = 2;

    // 1/sqrt(2 pi).
    private const double DensityAtZero = 0.3989422804014327;

    /// <summary>The probability that a value is below z, to 13 digits also far out.</summary>
    /// <remarks>Near the middle 1/2 + density(z) (z + z^3/3 + z^5/(3 5) + ...), in the tails density(z) / (z + 1/(z + 2/(z + 3/...)))
    /// (Abramowitz and Stegun, 26.2.11 and 26.2.14).</remarks>
    public static double Below(double z) =>
        double.IsNaN(z) ? z : z > Tail ? 1 - BeyondTail(z) : z < -Tail ? BeyondTail(-z) : 0.5 + (Density(z) * Series(z));

    /// <summary>The number that a value is below with a probability.</summary>
    /// <remarks>An approximation with an error below 4.5e-4 (Abramowitz and Stegun, 26.2.23), then three steps of Halley's method, of
    /// which each triples the number of digits.</remarks>
    /// <param name="probability">The probability, from 0 to 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The probability is not in this range.</exception>
    public static double Quantile(double probability)
    {
        if (!(probability >= 0 && probability <= 1))
        {
            throw new ArgumentOutOfRangeException(nameof(probability), probability, "A probability is from 0 to 1.");
        }

        if (probability > 0.5)
        {
            return -Quantile(1 - probability);
        }

        if (probability is 0 or 0.5)
        {
            return probability == 0 ? double.NegativeInfinity : 0;
        }

        var t = Math.Sqrt(-2 * Elementary.Log(probability));
        var z = ((2.515517 + (0.802853 * t) + (0.010328 * t * t)) / (1 + (1.432788 * t) + (0.189269 * t * t) + (0.001308 * t * t * t))) - t;
        for (var step = 0; step < 3; step++)
        {
            var off = (Below(z) - probability) / Density(z);
            z -= off / (1 + (z * off / 2));
        }

        return z;
    }

    private static double Density(double z)
    {
        var (square, error) = Parts.Product(z, z);
        return DensityAtZero * Exponential.Of(-square / 2, -error / 2);
    }

    private static double Series(double z)
    {
        var (sum, term) = (0.0, z);
        for (var odd = 3; sum + term != sum; odd += 2)
        {
            sum += term;
            term *= z * z / odd;
        }

        return sum;
    }

    private static double BeyondTail(double z)
    {
        if (double.IsInfinity(z))
        {
            return 0;
        }

        // The error was seen to fall as exp(-1.8 z sqrt(n)).
        var fraction = z;
        for (var n = 10 + (int)(450 / (z * z)); n > 0; n--)
        {
            fraction = z + (n / fraction);
        }

        return Density(z) / fraction;
    }
}
