using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The colors of a map: bands of equal width about round values, from the lowest value of the maps to the highest.</summary>
/// <param name="step">Width of a band, a round number.</param>
/// <param name="first">Index of the lowest band: its middle in steps.</param>
/// <param name="last">Index of the highest band.</param>
/// <param name="isSigned">True for errors: zero has the pale color in the middle, and both signs have colors of their own.</param>
internal sealed class ColorScale(double step, int first, int last, bool isSigned)
{
    /// <summary>Number of colors on either side of zero. The style sheet of reports has them for a dark page, as <c>.h0</c> to
    /// <c>.h40</c>.</summary>
    public const int MostBands = 20;

    // Less is below what any gauge shows.
    private const double LeastRangeUm = 0.1;

    /// <summary>Index of the lowest band.</summary>
    public int First => first;

    /// <summary>Index of the highest band.</summary>
    public int Last => last;

    /// <summary>A scale for errors: equal distances from zero have equally strong colors, and the largest has the strongest.</summary>
    public static ColorScale OfErrors(IEnumerable<double> valuesUm)
    {
        var (low, high) = Range(valuesUm);
        (low, high) = (Math.Min(low, 0), Math.Max(high, 0));
        var step = RoundNumber.AtLeast(Math.Max(Math.Max(-low, high), LeastRangeUm / 2) / MostBands);
        return new(step, Band(low, step), Band(high, step), true);
    }

    /// <summary>A scale for values without a sign, such as uncertainties: from pale for the lowest to strong for the highest.</summary>
    public static ColorScale OfSizes(IEnumerable<double> valuesUm)
    {
        var (low, high) = Range(valuesUm);
        var step = RoundNumber.AtLeast(Math.Max(high - low, LeastRangeUm / MostBands) / MostBands);
        return new(step, Band(low, step), Band(high, step), false);
    }

    /// <summary>The value in the middle of a band.</summary>
    public double Middle(int band) => band * step;

    /// <summary>The value between a band and the one below it.</summary>
    public double LowerEnd(int band) => (band - 0.5) * step;

    /// <summary>Index of a band's color: 0 to twice <see cref="MostBands"/>.</summary>
    public int ColorOf(int band)
    {
        var share = isSigned
            ? (double)band / Math.Max(1, Math.Max(-first, last))
            : last == first ? 0 : (double)(band - first) / (last - first);
        return MostBands + (int)Math.Round(share * MostBands, MidpointRounding.AwayFromZero);
    }

    /// <summary>A color as <c>#rrggbb</c>.</summary>
    public static string Hex(int color) => DivergingColors.HexAt(((double)color / MostBands) - 1);

    /// <summary>The text of a band.</summary>
    public string Label(int band) => (isSigned && band > 0 ? "+" : "") + ReportNumber.Short(Math.Round(Middle(band), 9));

    private static int Band(double value, double step) => (int)Math.Round(value / step, MidpointRounding.AwayFromZero);

    private static (double Low, double High) Range(IEnumerable<double> values)
    {
        var (low, high) = (double.MaxValue, double.MinValue);
        foreach (var value in values)
        {
            (low, high) = (Math.Min(low, value), Math.Max(high, value));
        }

        return low <= high ? (low, high) : (0, 0);
    }
}
