using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The exact decimal value of a word: <see cref="Digits"/> / 10^<see cref="Decimals"/>. Up to 18 digits, never rounded.</summary>
/// <param name="Digits">All digits as one signed integer.</param>
/// <param name="Decimals">Number of digits after the point, 0 to 18.</param>
public readonly record struct NcNumber(long Digits, int Decimals)
{
    /// <summary>Maximum number of digits that is represented exactly.</summary>
    public const int MaxDigits = 18;

    /// <summary>Number of digits that a double holds exactly.</summary>
    internal const int ExactDigits = 15;

    private static readonly long[] Powers = MakePowers();

    /// <summary>The nearest double: the correctly rounded decimal for up to 15 digits.</summary>
    public double Value => Decimals == 0 ? Digits : Digits / (double)Powers[Decimals];

    /// <summary>The decimal with a number of decimals that is nearest to a double; halves round away from zero.</summary>
    /// <exception cref="InputException">The value does not fit into 18 digits, or is not finite.</exception>
    public static NcNumber Round(double value, int decimals)
    {
        var scaled = Math.Round(value * Powers[decimals], MidpointRounding.AwayFromZero);
        return Math.Abs(scaled) < 9e17
            ? new((long)scaled, decimals)
            : throw new InputException(new Refusal(
                NcRefusalCodes.NumberTooLong,
                $"The value {value.ToString("R", CultureInfo.InvariantCulture)} does not fit into {MaxDigits} digits."));
    }

    /// <summary>The same value with at least the given number of decimals.</summary>
    /// <exception cref="InputException">The value does not fit into 18 digits.</exception>
    public NcNumber WithDecimals(int decimals)
    {
        if (decimals <= Decimals)
        {
            return this;
        }

        var factor = Powers[decimals - Decimals];
        return Math.Abs(Digits) <= 900_000_000_000_000_000 / factor
            ? new(Digits * factor, decimals)
            : throw new InputException(
                new Refusal(NcRefusalCodes.NumberTooLong, $"The number {this} has no room for {decimals} decimals."));
    }

    /// <summary>The same value without trailing zeros.</summary>
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

    /// <summary>True if both have the same value, regardless of their decimals.</summary>
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
