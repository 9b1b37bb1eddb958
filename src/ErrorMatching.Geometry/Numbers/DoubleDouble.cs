namespace ErrorMatching.Geometry;

/// <summary>A number with about 32 digits: the unevaluated sum of two nonoverlapping doubles. It has the range of <c>double</c> and twice
/// its precision, enough for badly conditioned fits of measured decimals without loss.</summary>
/// <remarks>Algorithms and error bounds: Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic", ACM TOMS 44 (2017). With u = 2^-53, the relative errors are below 4 u^2 (sum), 5 u^2 (product) and 15 u^2
/// (quotient), where u^2 = 1.2e-32, unless an intermediate result overflows or underflows. An undefined operation (0/0, root of a negative
/// number) gives NaN, as for <c>double</c>.</remarks>
public readonly partial record struct DoubleDouble : IComparable<DoubleDouble>
{
    private DoubleDouble(double high, double low) => (High, Low) = (high, low);

    /// <summary>Zero.</summary>
    public static DoubleDouble Zero => default;

    /// <summary>One.</summary>
    public static DoubleDouble One => new(1, 0);

    /// <summary>The leading part: the nearest double.</summary>
    public double High { get; }

    /// <summary>The remainder: at most half a unit in the last place of the leading part.</summary>
    public double Low { get; }

    /// <summary>True if the number is neither NaN nor infinite.</summary>
    public bool IsFinite => double.IsFinite(High) && double.IsFinite(Low);

    /// <summary>The square root; NaN for a negative number.</summary>
    public static DoubleDouble Sqrt(DoubleDouble value)
    {
        var root = Math.Sqrt(value.High);
        if (root == 0 || !double.IsFinite(root))
        {
            return root;
        }

        var rest = Math.FusedMultiplyAdd(-root, root, value.High) + value.Low;
        return FastSum(root, rest / (2 * root));
    }

    /// <summary>The absolute value.</summary>
    public static DoubleDouble Abs(DoubleDouble value) => value.High < 0 || (value.High == 0 && value.Low < 0) ? -value : value;

    /// <summary>The nearest double.</summary>
    public double ToDouble() => High;

    /// <inheritdoc/>
    public int CompareTo(DoubleDouble other)
    {
        var byHigh = High.CompareTo(other.High);
        return byHigh != 0 ? byHigh : Low.CompareTo(other.Low);
    }

    /// <summary>Converts a double exactly.</summary>
    public static implicit operator DoubleDouble(double value) => new(value, 0);

    /// <summary>The negated number.</summary>
    public static DoubleDouble operator -(DoubleDouble a) => new(-a.High, -a.Low);

    /// <summary>The sum.</summary>
    public static DoubleDouble operator +(DoubleDouble a, DoubleDouble b)
    {
        var (high, highRest) = Sum(a.High, b.High);
        var (low, lowRest) = Sum(a.Low, b.Low);
        var first = FastSum(high, highRest + low);
        return FastSum(first.High, lowRest + first.Low);
    }

    /// <summary>The difference.</summary>
    public static DoubleDouble operator -(DoubleDouble a, DoubleDouble b) => a + -b;

    /// <summary>The product.</summary>
    public static DoubleDouble operator *(DoubleDouble a, DoubleDouble b)
    {
        var (high, rest) = Product(a.High, b.High);
        var cross = Math.FusedMultiplyAdd(a.Low, b.High, Math.FusedMultiplyAdd(a.High, b.Low, a.Low * b.Low));
        return FastSum(high, rest + cross);
    }

    /// <summary>The quotient.</summary>
    public static DoubleDouble operator /(DoubleDouble a, DoubleDouble b)
    {
        var high = a.High / b.High;
        var (product, rest) = Product(b.High, high);
        var back = FastSum(product, Math.FusedMultiplyAdd(b.Low, high, rest));
        return FastSum(high, (a.High - back.High + (a.Low - back.Low)) / b.High);
    }

    /// <summary>True if the first is smaller.</summary>
    public static bool operator <(DoubleDouble a, DoubleDouble b) => a.High < b.High || (a.High == b.High && a.Low < b.Low);

    /// <summary>True if the first is larger.</summary>
    public static bool operator >(DoubleDouble a, DoubleDouble b) => b < a;

    /// <summary>True if the first is smaller or equal.</summary>
    public static bool operator <=(DoubleDouble a, DoubleDouble b) => a.High < b.High || (a.High == b.High && a.Low <= b.Low);

    /// <summary>True if the first is larger or equal.</summary>
    public static bool operator >=(DoubleDouble a, DoubleDouble b) => b <= a;

    /// <summary>The exact sum of two doubles in any order (Knuth's two-sum).</summary>
    private static (double Sum, double Error) Sum(double a, double b)
    {
        var sum = a + b;
        var partOfB = sum - a;
        return (sum, a - (sum - partOfB) + (b - partOfB));
    }

    /// <summary>The exact sum of two doubles, the larger one first (Dekker).</summary>
    private static DoubleDouble FastSum(double larger, double smaller)
    {
        var sum = larger + smaller;
        return new(sum, smaller - (sum - larger));
    }

    /// <summary>The exact product of two doubles.</summary>
    private static (double Product, double Error) Product(double a, double b)
    {
        var product = a * b;
        return (product, Math.FusedMultiplyAdd(a, b, -product));
    }
}
