using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Jobs;

/// <summary>Numbers as users type them.</summary>
internal static partial class DraftNumber
{
    /// <summary>The number in JSON notation, with the same digits but no plus sign, leading zeros or bare decimal sign; null if the text
    /// is not a number.</summary>
    public static string? Json(string text)
    {
        if (Form().Match(text.Trim()) is not { Success: true } match)
        {
            return null;
        }

        var (whole, decimals) = (match.Groups["whole"].Value.TrimStart('0'), match.Groups["decimals"].Value);
        return (match.Groups["sign"].ValueSpan is "-" or "\u2212" ? "-" : "") + (whole.Length > 0 ? whole : "0")
            + (decimals.Length > 0 ? "." + decimals : "") + match.Groups["power"].Value;
    }

    /// <summary>Its value; null if the text is not a number.</summary>
    public static double? Value(string text) =>
        Json(text) is { } json ? double.Parse(json, NumberStyles.Float, CultureInfo.InvariantCulture) : null;

    [GeneratedRegex(
        @"^(?<sign>[-+\u2212]?)(?=[0-9]|\.[0-9])(?<whole>[0-9]*)(\.(?<decimals>[0-9]*))?(?<power>([eE][-+]?[0-9]+)?)$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Form();
}
