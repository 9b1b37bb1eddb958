namespace ErrorMatching.Freeform;

/// <summary>Whether errors of neighboring points are more alike than chance makes them: Moran's I, with its mean and variance if the errors were dealt to the points at random.</summary>
/// <remarks>
/// P. A. P. Moran, "Notes on Continuous Stochastic Phenomena", 1950; moments under randomization by A. D. Cliff and J. K. Ord, Spatial Processes, 1981, section 1.5. Two points are neighbors, with weight one, if either is among
/// the four nearest of the other.
/// </remarks>
/// <param name="I">Moran's I: 1 where neighbors are alike, about zero where they are not, negative where they alternate.</param>
/// <param name="Expected">Its mean for errors without structure, -1 / (n - 1).</param>
/// <param name="Variance">Its variance for errors without structure.</param>
/// <param name="Z">How many standard deviations it lies above its mean.</param>
/// <param name="P">Probability of such a value or a higher one without structure, by the normal distribution.</param>
public sealed record SpatialStructure(double I, double Expected, double Variance, double Z, double P)
{
    /// <summary>A probability below this one means structure.</summary>
    public const double Level = 0.05;

    // Below this the normal distribution says little.
    private const int FewestPoints = 8;
    private const int Nearest = 4;

    /// <summary>True if what differs from the mean is systematic; false if it looks like noise.</summary>
    public bool IsSystematic => P < Level;

    /// <summary>The structure of some errors; null if they are too few or all alike, so that nothing can be said.</summary>
    public static SpatialStructure? Of(IReadOnlyList<ErrorSample> samples)
    {
        ArgumentNullException.ThrowIfNull(samples);
        return samples.Count < FewestPoints ? null : Of([.. samples.Select(s => s.ErrorMm)], Neighbors(samples));
    }

    /// <summary>The structure of values with given neighbors; each pair of neighbors is in the list once.</summary>
    internal static SpatialStructure? Of(double[] values, IReadOnlyCollection<(int A, int B)> neighbors)
    {
        double n = values.Length;
        var mean = values.Average();
        var m2 = values.Sum(v => Math.Pow(v - mean, 2)) / n;
        var m4 = values.Sum(v => Math.Pow(v - mean, 4)) / n;
        if (!(m2 > 0) || neighbors.Count == 0)
        {
            return null;
        }

        var degree = new double[values.Length];
        var products = 0.0;
        foreach (var (a, b) in neighbors)
        {
            degree[a]++;
            degree[b]++;
            products += 2 * (values[a] - mean) * (values[b] - mean);
        }

        // Weights of one both ways: S0 counts ordered pairs, S1 is half the sum of (1 + 1)^2 over them, S2 the sum of (2 degree)^2.
        double s0 = 2 * neighbors.Count, s1 = 4 * neighbors.Count, s2 = degree.Sum(d => 4 * d * d);
        var kurtosis = m4 / (m2 * m2);
        var (i, expected) = (products / (s0 * m2), -1 / (n - 1));
        var square = ((n * ((((n * n) - (3 * n) + 3) * s1) - (n * s2) + (3 * s0 * s0))) - (kurtosis * ((((n * n) - n) * s1) - (2 * n * s2) + (6 * s0 * s0))))
            / ((n - 1) * (n - 2) * (n - 3) * s0 * s0);
        var variance = square - (expected * expected);
        var z = (i - expected) / Math.Sqrt(variance);
        return new(i, expected, variance, z, UpperTail(z));
    }

    private static HashSet<(int A, int B)> Neighbors(IReadOnlyList<ErrorSample> samples)
    {
        var pairs = new HashSet<(int, int)>();
        var order = new int[samples.Count];
        var distances = new double[samples.Count];
        for (var a = 0; a < samples.Count; a++)
        {
            for (var b = 0; b < samples.Count; b++)
            {
                (order[b], distances[b]) = (b, a == b ? double.MaxValue : (samples[b].Nominal - samples[a].Nominal).Length);
            }

            // Equal distances go by number, so that the result does not hang on the sort.
            foreach (var b in order.OrderBy(k => distances[k]).ThenBy(k => k).Take(Nearest))
            {
                pairs.Add((Math.Min(a, b), Math.Max(a, b)));
            }
        }

        return pairs;
    }

    // 1 - Phi(z) by the continued fraction of the error function beyond 2 (Abramowitz and Stegun, 26.2.14), its series below (26.2.10).
    private static double UpperTail(double z)
    {
        if (z < 0)
        {
            return 1 - UpperTail(-z);
        }

        var density = Math.Exp(-z * z / 2) / Math.Sqrt(2 * Math.PI);
        if (z > 2)
        {
            var fraction = z;
            for (var k = 60; k >= 1; k--)
            {
                fraction = z + (k / fraction);
            }

            return density / fraction;
        }

        double term = z, sum = z;
        for (var k = 1; k < 60; k++)
        {
            term *= z * z / ((2 * k) + 1);
            sum += term;
        }

        return 0.5 - (density * sum);
    }
}
