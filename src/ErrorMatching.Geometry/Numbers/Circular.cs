using System.Runtime.CompilerServices;

namespace ErrorMatching.Geometry;

/// <summary>Sine, cosine and tangent of angles in radians.</summary>
/// <remarks>What is left of an angle after whole quarter turns is j/64 + d with |d| up to 1/128. Sine and cosine follow from those of j/64
/// in a table and the series of d. The product with d itself is exact; all else is below 2^-14 of the result. Near zero, the sine is its
/// own series.</remarks>
internal static class Circular
{
    // Below it, the series to r^9 leaves out less than 1e-19 of the sine.
    private const int FirstOfTable = 4;

    public static double Sine(double x)
    {
        var turns = QuarterTurns.Split(Math.Abs(x), out var r, out var rest);
        var size = (turns & 1) == 0 ? SineOf(r, rest).High : CosineOf(r, rest).High;
        return (turns & 2) != 0 ^ double.IsNegative(x) ? -size : size;
    }

    public static double Cosine(double x)
    {
        var turns = QuarterTurns.Split(Math.Abs(x), out var r, out var rest);
        var size = (turns & 1) == 0 ? CosineOf(r, rest).High : SineOf(r, rest).High;
        return turns is 1 or 2 ? -size : size;
    }

    public static (double Sin, double Cos) Both(double x)
    {
        var turns = QuarterTurns.Split(Math.Abs(x), out var r, out var rest);
        var (sine, cosine) = (SineOf(r, rest).High, CosineOf(r, rest).High);
        (sine, cosine) = (turns & 1) == 0 ? (sine, cosine) : (cosine, sine);
        return ((turns & 2) != 0 ^ double.IsNegative(x) ? -sine : sine, turns is 1 or 2 ? -cosine : cosine);
    }

    public static double Tangent(double x)
    {
        var turns = QuarterTurns.Split(Math.Abs(x), out var r, out var rest);
        var (sine, cosine) = (SineOf(r, rest), CosineOf(r, rest));
        var size = (turns & 1) == 0 ? Parts.Quotient(sine, cosine).High : -Parts.Quotient(cosine, sine).High;
        return double.IsNegative(x) ? -size : size;
    }

    private static (double High, double Low) SineOf(double r, double rest)
    {
        if (r < 0)
        {
            var (high, low) = SineOf(-r, -rest);
            return (-high, -low);
        }

        var j = Nearest(r);
        if (j < FirstOfTable)
        {
            var z = r * r;
            return Parts.FastSum(r, rest + (r * z * ((-1.0 / 6) + (z * ((1.0 / 120) - (z * ((1.0 / 5040) - (z * (1.0 / 362880)))))))));
        }

        var (d, first, second) = Beyond(r, rest, j);
        var (s, sRest, c, cRest) = Entry(j);
        var (sum, lost) = Parts.FastSum(s, c * first);
        return Parts.FastSum(sum, lost + (sRest + (c * second) + (cRest * d) + ((s + sRest) * Bend(d)) + ((c + cRest) * Cubic(d))));
    }

    private static (double High, double Low) CosineOf(double r, double rest)
    {
        (r, rest) = r < 0 ? (-r, -rest) : (r, rest);
        var j = Nearest(r);
        var (d, first, second) = Beyond(r, rest, j);
        var (s, sRest, c, cRest) = Entry(j);
        var (sum, lost) = Parts.FastSum(c, -s * first);
        return Parts.FastSum(sum, lost + (cRest - (s * second) - (sRest * d) + ((c + cRest) * Bend(d)) - ((s + sRest) * Cubic(d))));
    }

    private static int Nearest(double r) => (int)((r * 64) + 0.5);

    // d, and its two parts: the first has 26 bits.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (double D, double First, double Second) Beyond(double r, double rest, int j)
    {
        var (d, low) = Parts.FastSum(r - (j / 64.0), rest);
        var first = Parts.First(d);
        return (d, first, d - first + low);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (double Sine, double SineRest, double Cosine, double CosineRest) Entry(int j)
    {
        var entry = ElementaryTables.Sines.Slice(4 * j, 4);
        return (entry[0], entry[1], entry[2], entry[3]);
    }

    // cos d - 1, and sin d - d.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Bend(double d)
    {
        var z = d * d;
        return z * (-0.5 + (z * ((1.0 / 24) - (z * (1.0 / 720)))));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Cubic(double d)
    {
        var z = d * d;
        return d * z * ((-1.0 / 6) + (z * ((1.0 / 120) - (z * (1.0 / 5040)))));
    }
}
