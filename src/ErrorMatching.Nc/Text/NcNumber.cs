using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>
/// The exact decimal value of a word: <see cref="Digits"/> / 10^<see cref="Decimals"/>. Up to 18 digits, no rounding anywhere.
/// </summary>
/// <param name="Digits">All digits as one signed integer.</param>
/// <param name="Decimals">How many of them stand behind the point, 0 to 18.</param>
public readonly record struct NcNumber(long Digits, int Decimals)
{
    /// <summary>Longest number that is represented exactly.</summary>
    public const int MaxDigits = 18;

    private static readonly long[] Powers = MakePowers();

    /// <summary>The nearest double: exactly the decimal's correctly rounded value for up to 15 digits.</summary>
    public double Value => Decimals == 0 ? Digits : Digits / (double)Powers[Decimals];

    /// <summary>The decimal nearest to a double at a number of decimals; halves away from zero.</summary>
    /// <exception cref="NcException">The value does not fit into 18 digits, or is not finite.</exception>
    public static NcNumber Round(double value, int decimals)
    {
        var scaled = Math.Round(value * Powers[decimals], MidpointRounding.AwayFromZero);
        return Math.Abs(scaled) < 9e17
            ? new((long)scaled, decimals)
            : throw new NcException(
                NcErrorCode.NumberTooLong,
                $"The value {value.ToString("R", CultureInfo.InvariantCulture)} does not fit into {MaxDigits} digits.");
    }

    /// <summary>The same value with at least a number of decimals.</summary>
    /// <exception cref="NcException">The value does not fit into 18 digits.</exception>
    public NcNumber WithDecimals(int decimals)
    {
        if (decimals <= Decimals)
        {
            return this;
        }

        var factor = Powers[decimals - Decimals];
        return Math.Abs(Digits) <= 900_000_000_000_000_000 / factor
            ? new(Digits * factor, decimals)
            : throw new NcException(NcErrorCode.NumberTooLong, $"The number {this} has no room for {decimals} decimals.");
    }

    /// <summary>The same value without zeros at the end.</summary>
    public NcNumber Trim()
    {
        var (digits, decimals) = (Digits, Decimals);
        while (decimals > 0 && digits % 10 == 0)
        {
            digits /= 10;
            decimals--;
        }

        return new(digits, decimals);
    }

    /// <summary>True if both are the same value, however many decimals each has.</summary>
    public bool SameValue(NcNumber other) => Trim() == other.Trim();

    /// <summary>The exact sum.</summary>
    public static NcNumber operator +(NcNumber a, NcNumber b)
    {
        var decimals = Math.Max(a.Decimals, b.Decimals);
        return new(checked(a.WithDecimals(decimals).Digits + b.WithDecimals(decimals).Digits), decimals);
    }

    /// <summary>The exact difference.</summary>
    public static NcNumber operator -(NcNumber a, NcNumber b) => a + new NcNumber(-b.Digits, b.Decimals);

    /// <summary>The plain decimal text, with all decimals.</summary>
    public override string ToString()
    {
        var text = Math.Abs(Digits).ToString(CultureInfo.InvariantCulture).PadLeft(Decimals + 1, '0');
        return (Digits < 0 ? "-" : "") + (Decimals == 0 ? text : text[..^Decimals] + "." + text[^Decimals..]);
    }

    private static long[] MakePowers()
    {
        var powers = new long[MaxDigits + 1];
        powers[0] = 1;
        for (var i = 1; i < powers.Length; i++)
        {
            powers[i] = powers[i - 1] * 10;
        }

        return powers;
    }
}
