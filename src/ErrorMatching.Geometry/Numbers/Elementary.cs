namespace ErrorMatching.Geometry;

/// <summary>Elementary functions that give the same bits on every system and processor. Those of <see cref="Math"/> are the system's
/// own, which differ in the last digit.</summary>
/// <remarks>
/// They consist of additions, multiplications, divisions and square roots of doubles, which IEEE 754 defines to the last bit. Each result
/// is within 0.51 units in the last place of the exact one: an argument is brought near an entry of a table, a short Taylor series adds
/// the rest, and the sums keep twice the digits where that matters (P. T. P. Tang, ACM Trans. Math. Software 15 (1989) 144 and
/// 16 (1990) 378; J.-M. Muller, Elementary Functions, 2016). Angles are in radians. Limits, zeros with a sign and NaN are as in
/// <see cref="Math"/>.
/// </remarks>
public static class Elementary
{
    /// <summary>e^x.</summary>
    public static double Exp(double x) => Exponential.Of(x, 0);

    /// <summary>The natural logarithm; NaN for a negative number, minus infinity for 0.</summary>
    public static double Log(double x) => Logarithm.IsDefined(x, out var limit) ? Logarithm.Of(x).High : limit;

    /// <summary>The logarithm to the base 10, exact for powers of ten; NaN for a negative number, minus infinity for 0.</summary>
    public static double Log10(double x) => Logarithm.IsDefined(x, out var limit) ? Logarithm.Decimal(x) : limit;

    /// <summary>The power with the limits of IEEE 754; NaN for a negative base and an exponent that is not whole. A power that a double
    /// can hold is exact.</summary>
    public static double Pow(double x, double exponent) => Exponential.Power(x, exponent);

    /// <summary>The sine; NaN for an infinite angle.</summary>
    public static double Sin(double x) => Circular.Sine(x);

    /// <summary>The cosine; NaN for an infinite angle.</summary>
    public static double Cos(double x) => Circular.Cosine(x);

    /// <summary>Sine and cosine, the same as one by one.</summary>
    public static (double Sin, double Cos) SinCos(double x) => Circular.Both(x);

    /// <summary>The tangent; NaN for an infinite angle.</summary>
    public static double Tan(double x) => Circular.Tangent(x);

    /// <summary>The arc sine, from -pi/2 to pi/2; NaN outside -1 to 1.</summary>
    public static double Asin(double x) => ArcTangent.Sine(x);

    /// <summary>The arc cosine, from 0 to pi; NaN outside -1 to 1.</summary>
    public static double Acos(double x) => ArcTangent.Cosine(x);

    /// <summary>The arc tangent, from -pi/2 to pi/2.</summary>
    public static double Atan(double x) => ArcTangent.Of(x, 1);

    /// <summary>The angle of the point (x, y), from -pi to pi.</summary>
    public static double Atan2(double y, double x) => ArcTangent.Of(y, x);
}
