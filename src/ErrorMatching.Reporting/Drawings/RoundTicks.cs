namespace ErrorMatching.Reporting;

/// <summary>Round values for the ticks of an axis.</summary>
public static class RoundTicks
{
    /// <summary>Multiples of a round step within a range.</summary>
    /// <param name="low">Lower end of the range.</param>
    /// <param name="high">Upper end of the range, above the lower one.</param>
    /// <param name="most">About the largest number of ticks; at least 1.</param>
    public static IReadOnlyList<double> Within(double low, double high, int most)
    {
        var step = RoundNumber.AtLeast((high - low) / most);

        // A tick on an end is one in spite of rounding.
        var (first, last) = ((int)Math.Ceiling((low / step) - 1e-6), (int)Math.Floor((high / step) + 1e-6));
        return [.. Enumerable.Range(first, Math.Max(0, last - first + 1)).Select(k => Math.Round(k * step, 9) + 0.0)];
    }
}
