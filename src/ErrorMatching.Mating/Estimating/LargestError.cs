using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A bound of the largest of many errors whose uncertainties depend on each other.</summary>
internal static class LargestError
{
    // The same numbers for the same input, on every system.
    private const ulong Seed = 0x0F1E2D3C4B5A6978;

    // Draws, each with its mirror image. A quantile of 95 % is off by about 2 % of itself, by 3 % where five points tell the scale, and by
    // 5 % where three do.
    private const int Draws = 2000;

    /// <summary>The value that the largest error, either way, exceeds with a given risk: boundaries are drawn from what is known about
    /// them, and the largest error of each is taken over all places.</summary>
    /// <param name="expectedMm">The expected errors.</param>
    /// <param name="unknown">What is not known about them: columns that one standard normal number scales each.</param>
    /// <param name="scale">How well the scale of the columns is known; null for a scale that is known.</param>
    /// <param name="risk">The risk, above 0 and below 1.</param>
    public static double BoundMm(IReadOnlyList<double> expectedMm, IReadOnlyList<double[]> unknown, ColumnScale? scale, double risk)
    {
        var variates = new NormalVariates(Seed);
        var (off, largest) = (new double[expectedMm.Count], new double[2 * Draws]);
        for (var draw = 0; draw < Draws; draw++)
        {
            Array.Clear(off);
            var ratio = scale?.Draw(variates) ?? 1;
            for (var c = 0; c < unknown.Count; c++)
            {
                var (column, by) = (unknown[c], (scale?.Of(c, ratio) ?? 1) * variates.Next());
                for (var k = 0; k < off.Length; k++)
                {
                    off[k] += by * column[k];
                }
            }

            for (var k = 0; k < off.Length; k++)
            {
                largest[2 * draw] = Math.Max(largest[2 * draw], Math.Abs(expectedMm[k] + off[k]));
                largest[(2 * draw) + 1] = Math.Max(largest[(2 * draw) + 1], Math.Abs(expectedMm[k] - off[k]));
            }
        }

        Array.Sort(largest);
        return largest[(int)Math.Ceiling((1 - risk) * largest.Length) - 1];
    }
}

/// <summary>The scale of the errors' uncertainty if only the points themselves show it. It is no better known than they show it, so the
/// errors follow Student's distribution.</summary>
/// <param name="Freedom">Number of independent values that tell it, 1 or more.</param>
/// <param name="Of">The factor of a column, by its number, where the true standard deviation is so many times the one that they
/// show.</param>
internal sealed record ColumnScale(int Freedom, Func<int, double, double> Of)
{
    /// <summary>Columns that all have the scale of some points, less one point for the mean.</summary>
    public static ColumnScale ToldBy(int points) => new(Math.Max(1, points - 1), (_, ratio) => ratio);

    /// <summary>Draws how many times the true standard deviation is the one that the values show.</summary>
    public double Draw(NormalVariates variates)
    {
        var squares = 0.0;
        for (var k = 0; k < Freedom; k++)
        {
            var variate = variates.Next();
            squares += variate * variate;
        }

        return Math.Sqrt(Freedom / squares);
    }
}

/// <summary>Numbers of the standard normal distribution, the same for the same seed on every system.</summary>
/// <remarks>Two at a time from two equally distributed ones (G. E. P. Box and M. E. Muller, 1958), which SplitMix64 gives (Steele, Lea and
/// Flood, 2014).</remarks>
internal sealed class NormalVariates(ulong seed)
{
    private ulong _state = seed;
    private double? _second;

    /// <summary>The next number.</summary>
    public double Next()
    {
        if (_second is { } second)
        {
            _second = null;
            return second;
        }

        var (radius, (sine, cosine)) = (Math.Sqrt(-2 * Elementary.Log(Uniform())), Elementary.SinCos(2 * Math.PI * Uniform()));
        _second = radius * sine;
        return radius * cosine;
    }

    // Between 0 and 1, neither of them.
    private double Uniform()
    {
        _state += 0x9E3779B97F4A7C15;
        var z = _state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return (((z ^ (z >> 31)) >> 11) + 0.5) / (1UL << 53);
    }
}
