namespace ErrorMatching.Geometry;

/// <summary>Logarithms of positive numbers.</summary>
/// <remarks>x = 2^k m with m between sqrt(1/2) and sqrt(2). For i, the nearest whole number to 128 m, the table has c, near 128/i, so that
/// m c = 1 + r with |r| below 0.0062. Then ln x = k ln 2 - ln c + ln(1 + r). c is 1 for m near 1: there, nothing cancels. The series to
/// r^10/10 leaves out less than 1e-23 of the result; r, its square and the constants have twice the digits of a double.</remarks>
internal static class Logarithm
{
    private const int FirstEntry = 91, MantissaBits = 52;

    private const long RootOfHalf = 0x3FE6A09E667F3BCD;

    // Below it, numbers have fewer digits; 2^54 makes them normal.
    private const double SmallestNormal = 2.2250738585072014e-308, Scale = 18014398509481984;
    private const int ScaleBits = 54;

    /// <summary>True for a positive finite number.</summary>
    /// <param name="x">The number.</param>
    /// <param name="limit">The logarithm of another one.</param>
    public static bool IsDefined(double x, out double limit)
    {
        limit = x == 0 ? double.NegativeInfinity : x > 0 ? x : double.NaN;
        return x > 0 && x < double.PositiveInfinity;
    }

    /// <summary>The natural logarithm of a positive finite number in two parts, to 2^-68 of it.</summary>
    public static (double High, double Low) Of(double x)
    {
        var isSubnormal = x < SmallestNormal;
        var bits = BitConverter.DoubleToInt64Bits(isSubnormal ? x * Scale : x);
        var k = (int)((bits - RootOfHalf) >> MantissaBits);
        var m = BitConverter.Int64BitsToDouble(bits - ((long)k << MantissaBits));
        k -= isSubnormal ? ScaleBits : 0;

        var entry = ElementaryTables.Logarithms.Slice(3 * ((int)((m * 128) + 0.5) - FirstEntry), 3);
        var (c, first) = (entry[0], Parts.First(m));
        var (r, rest) = Parts.Sum((first * c) - 1, (m - first) * c);
        var (square, error) = Parts.Product(r, r);
        var (sum, lost) = Parts.FastSum((k * ElementaryTables.LogOfTwoHigh) + entry[1], r);
        (sum, var lostBySquare) = Parts.FastSum(sum, -0.5 * square);
        var constants = entry[2] + (k * ElementaryTables.LogOfTwoLow);
        var cubic = r * square * Series(r);
        return Parts.FastSum(sum, lost + lostBySquare + (rest - (rest * r) - (0.5 * error)) + constants + cubic);
    }

    // (ln(1 + r) - r + r^2/2) / r^3.
    private static double Series(double r) =>
        (1.0 / 3) - (r * (0.25 - (r * (0.2 - (r * ((1.0 / 6) - (r * ((1.0 / 7) - (r * (0.125 - (r * ((1.0 / 9) - (r * 0.1)))))))))))));

    /// <summary>The logarithm to the base 10 of a positive finite number.</summary>
    public static double Decimal(double x)
    {
        var (high, low) = Of(x);
        var (factor, first) = (ElementaryTables.PerLogOfTenHigh, Parts.First(high));
        return (first * factor)
            + (((high - first) * factor) + ((low * factor) + (high * ElementaryTables.PerLogOfTenLow)));
    }
}
