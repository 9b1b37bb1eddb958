using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>Formats real numbers for IGES and STEP: always with a decimal point, in the fewest digits that round-trip.</summary>
internal static class ExchangeNumber
{
    public static string Of(double value)
    {
        var text = value == 0 ? "0" : value.ToString("R", CultureInfo.InvariantCulture);
        var exponent = text.IndexOf('E', StringComparison.Ordinal);
        var mantissa = exponent < 0 ? text : text[..exponent];
        return (mantissa.Contains('.', StringComparison.Ordinal) ? mantissa : mantissa + ".") + (exponent < 0 ? "" : text[exponent..]);
    }
}
