using System.Globalization;
using System.Numerics;

namespace ErrorMatching.Geometry;

/// <summary>Takes whole quarter turns off an angle.</summary>
/// <remarks>Up to a million radians, pi/2 is subtracted in parts whose multiples are exact (W. J. Cody and W. Waite, Software Manual for
/// the Elementary Functions, 1980). Beyond, the angle is multiplied by 1200 binary digits of 2/pi (M. H. Payne and R. N. Hanek, SIGNUM
/// Newsletter 18 (1983) 19). No double is nearer to a multiple of pi/2 than 2^-62, and both ways are exact to 2^-130.</remarks>
internal static class QuarterTurns
{
    private const double Eighth = 0.7853981633974483, Large = 1e6;

    // Adding it rounds to whole numbers.
    private const double Rounder = 6755399441055744;

    // Binary digits of 2/pi, and of those of a product that are kept.
    private const int Digits = 1200, Kept = 200;

    // 2^-200.
    private const double LastKept = 6.223015277861142e-61;

    private const int MantissaBits = 52, ExponentOfOne = 1075;

    private static readonly BigInteger PerUnit = BigInteger.Parse(
        ElementaryTables.QuarterTurnsPerUnitDigits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);

    /// <summary>x = quarters pi/2 + r + rest.</summary>
    /// <param name="x">The angle, 0 or more.</param>
    /// <param name="r">What is left, at most pi/4; NaN for an infinite angle.</param>
    /// <param name="rest">The digits after those of r.</param>
    /// <returns>The last two binary digits of the quarters.</returns>
    public static int Split(double x, out double r, out double rest)
    {
        if (x <= Eighth)
        {
            (r, rest) = (x, 0);
            return 0;
        }

        if (!(x <= Large))
        {
            return SplitLarge(x, out r, out rest);
        }

        // The last digits of the sum are the whole number in binary.
        var rounded = (x * ElementaryTables.QuarterTurnsPerUnit) + Rounder;
        var quarters = rounded - Rounder;
        var (sum, lost) = Parts.Sum(x - (quarters * ElementaryTables.QuarterTurnFirst), -quarters * ElementaryTables.QuarterTurnSecond);
        (sum, var lostAgain) = Parts.Sum(sum, -quarters * ElementaryTables.QuarterTurnThird);
        (r, rest) = Parts.FastSum(sum, lost + lostAgain - (quarters * ElementaryTables.QuarterTurnRest));
        return (int)BitConverter.DoubleToInt64Bits(rounded) & 3;
    }

    private static int SplitLarge(double x, out double r, out double rest)
    {
        if (!double.IsFinite(x))
        {
            (r, rest) = (double.NaN, 0);
            return 0;
        }

        var bits = BitConverter.DoubleToInt64Bits(x);
        var mantissa = (bits & ((1L << MantissaBits) - 1)) | (1L << MantissaBits);
        var shift = Digits + ExponentOfOne - (int)(bits >> MantissaBits);

        // Whole quarters, then the binary digits after them; what is beyond a half becomes negative.
        var turns = (PerUnit * mantissa) >> (shift - Kept);
        var quarters = (turns + (BigInteger.One << (Kept - 1))) >> Kept;
        var fraction = turns - (quarters << Kept);
        var high = (double)fraction;
        var (first, second) = (high * LastKept, (double)(fraction - new BigInteger(high)) * LastKept);
        var (product, error) = Parts.Product(first, ElementaryTables.QuarterTurnHigh);
        (r, rest) = Parts.FastSum(
            product, error + ((first * ElementaryTables.QuarterTurnLow) + (second * ElementaryTables.QuarterTurnHigh)));
        return (int)(quarters & 3);
    }
}
