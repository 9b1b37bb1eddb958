namespace ErrorMatching.Geometry;

/// <summary>Exponentials and powers.</summary>
/// <remarks>x = (64 e + j) ln 2 / 64 + r with |r| below 0.0055. The result is 2^e times 2^(j/64) of a table times exp(r), whose series to
/// r^6/720 leaves out less than 3e-20. Only the product with r, below 2^-7 of the result, is rounded before the last sum.</remarks>
internal static class Exponential
{
    // Beyond these, results are infinite, or round to zero.
    private const double Highest = 709.782712893384, Lowest = -745.1332191019412;

    // Adding it rounds to whole numbers.
    private const double Rounder = 6755399441055744;

    private const int SmallestNormal = -1022, Bias = 1023, MantissaBits = 52;

    // Where an exponent is so large, every power is 0, 1 or infinite, and products with it would overflow.
    private const double LargeExponent = 1e25;

    /// <summary>exp(x + rest).</summary>
    public static double Of(double x, double rest)
    {
        if (!(x <= Highest && x >= Lowest))
        {
            return double.IsNaN(x) ? x : x > 0 ? double.PositiveInfinity : 0;
        }

        // The last digits of the sum are the whole number in binary.
        var rounded = (x * ElementaryTables.StepsPerUnit) + Rounder;
        var (whole, steps) = ((int)BitConverter.DoubleToInt64Bits(rounded), rounded - Rounder);
        var r = x - (steps * ElementaryTables.StepHigh) - ((steps * ElementaryTables.StepLow) - rest);
        var z = r * r;
        var series = r + (z * (0.5 + (r * (1.0 / 6)) + (z * ((1.0 / 24) + (r * (1.0 / 120)) + (z * (1.0 / 720))))));
        var table = ElementaryTables.Powers;
        var (j, exponent) = (2 * (whole & 63), whole >> 6);
        var (high, low) = (table[j], table[j + 1] + (table[j] * series));
        return exponent is >= SmallestNormal and < Bias ? (high + low) * PowerOfTwo(exponent)
            : exponent >= Bias ? (high + low) * 2 * PowerOfTwo(exponent - 1)
            : Subnormal(high, low, exponent);
    }

    /// <summary>x^exponent.</summary>
    public static double Power(double x, double exponent)
    {
        if (exponent == 0 || x == 1)
        {
            return 1;
        }

        if (double.IsNaN(x) || double.IsNaN(exponent))
        {
            return double.NaN;
        }

        // From 2^53 on, every number is whole and even.
        var isWhole = exponent == Math.Floor(exponent);
        var isOdd = isWhole && Math.Abs(exponent) < 9007199254740992 && ((long)exponent & 1) != 0;
        var size = Math.Abs(x);
        if (size == 0 || double.IsInfinity(size) || size == 1 || double.IsInfinity(exponent))
        {
            var limit = size == 1 ? 1 : size > 1 == exponent > 0 ? double.PositiveInfinity : 0;
            return x < 0 && size == 1 && !isWhole && double.IsFinite(exponent) ? double.NaN
                : double.IsNegative(x) && isOdd ? -limit
                : limit;
        }

        return x < 0 && !isWhole ? double.NaN : x < 0 && isOdd ? -Positive(size, exponent) : Positive(size, exponent);
    }

    private static double Positive(double x, double exponent)
    {
        switch (exponent)
        {
            case 1: return x;
            case 2: return x * x;
            case -1: return 1 / x;
            case 0.5: return Math.Sqrt(x);
        }

        var (high, low) = Logarithm.Of(x);
        exponent = Math.Clamp(exponent, -LargeExponent, LargeExponent);
        var (product, error) = Parts.Product(exponent, high);
        return Of(product, error + (exponent * low));
    }

    private static double PowerOfTwo(int exponent) => BitConverter.Int64BitsToDouble((long)(exponent + Bias) << MantissaBits);

    // Rounds once, to a multiple of the smallest number.
    private static double Subnormal(double high, double low, int exponent)
    {
        var rounder = PowerOfTwo(SmallestNormal - exponent);
        var sum = rounder + high;
        var rounded = sum + ((rounder - sum) + high + low) - rounder;
        return rounded * PowerOfTwo(SmallestNormal) * PowerOfTwo(exponent - SmallestNormal);
    }
}
