using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>Numbers as IGES and STEP spell reals: always with a point, and in the fewest digits that give the same double back.</summary>
internal static class ExchangeNumber
{
    /// <summary>The number's text.</summary>
    public static string Of(double value)
    {
        var text = value == 0 ? "0" : value.ToString("R", CultureInfo.InvariantCulture);
        var exponent = text.IndexOf('E', StringComparison.Ordinal);
        var mantissa = exponent < 0 ? text : text[..exponent];
        return (mantissa.Contains('.', StringComparison.Ordinal) ? mantissa : mantissa + ".") + (exponent < 0 ? "" : text[exponent..]);
    }
}
