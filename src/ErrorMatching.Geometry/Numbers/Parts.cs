using System.Runtime.CompilerServices;

namespace ErrorMatching.Geometry;

/// <summary>Exact sums and products of doubles as a rounded result and its error, without a fused multiplication, which is slow where a
/// processor or code compiled ahead has none (D. E. Knuth; T. J. Dekker, Numer. Math. 18 (1971) 224).</summary>
internal static class Parts
{
    private const ulong FirstBits = 0xFFFF_FFFF_F800_0000;

    /// <summary>The first 26 bits of a number. The rest has at most 27, and products of two first parts, or of one and a rest, are
    /// exact.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double First(double x) => BitConverter.UInt64BitsToDouble(BitConverter.DoubleToUInt64Bits(x) & FirstBits);

    /// <summary>The sum of two numbers; the first is larger or 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (double High, double Low) FastSum(double larger, double smaller)
    {
        var sum = larger + smaller;
        return (sum, smaller - (sum - larger));
    }

    /// <summary>The sum of two numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (double High, double Low) Sum(double a, double b)
    {
        var sum = a + b;
        var partOfB = sum - a;
        return (sum, a - (sum - partOfB) + (b - partOfB));
    }

    /// <summary>The product of two numbers; its error to one bit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (double High, double Low) Product(double a, double b)
    {
        var (product, firstA, firstB) = (a * b, First(a), First(b));
        var (restA, restB) = (a - firstA, b - firstB);
        return (product, ((firstA * firstB) - product) + (firstA * restB) + (restA * firstB) + (restA * restB));
    }

    /// <summary>The quotient of two numbers of two parts each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (double High, double Low) Quotient((double High, double Low) a, (double High, double Low) b)
    {
        var quotient = a.High / b.High;
        var (product, error) = Product(quotient, b.High);
        return FastSum(quotient, (a.High - product - error + (a.Low - (quotient * b.Low))) / b.High);
    }
}
