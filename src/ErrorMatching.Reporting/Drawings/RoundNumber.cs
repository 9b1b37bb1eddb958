using ErrorMatching.Geometry;

namespace ErrorMatching.Reporting;

/// <summary>Round numbers for axes: 1, 2 or 5 times a power of ten.</summary>
public static class RoundNumber
{
    /// <summary>The smallest round number not below a positive number.</summary>
    public static double AtLeast(double value) => Search(value, m => m >= value * (1 - 1e-12), [1, 2, 5, 10]);

    /// <summary>The largest round number not above a positive number.</summary>
    public static double AtMost(double value) => Search(value, m => m <= value * (1 + 1e-12), [5, 2, 1]);

    private static double Search(double value, Func<double, bool> fits, ReadOnlySpan<int> mantissas)
    {
        var exponent = (int)Math.Floor(Elementary.Log10(value));
        foreach (var mantissa in mantissas)
        {
            // A division by a power of ten is rounded once, so that 0.1 is the nearest double.
            var number = exponent < 0 ? mantissa / Elementary.Pow(10, -exponent) : mantissa * Elementary.Pow(10, exponent);
            if (fits(number))
            {
                return number;
            }
        }

        return value;
    }
}
