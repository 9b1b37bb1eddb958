using System.Text.RegularExpressions;

namespace ErrorMatching.Measurement;

/// <summary>Explains why a text is not a number, for the person who has to correct a file.</summary>
internal static partial class NumberDefect
{
    /// <summary>Returns the code and expectation for a text that is not a plain decimal number.</summary>
    public static (string Code, string Expected) Of(string text, bool decimalComma, bool isFixed)
    {
        var example = decimalComma ? "a number such as 12,345 or -5e-3" : "a number such as 12.345 or -5e-3";
        var (code, advice) = text switch
        {
            "" => (MeasurementError.EmptyCell, ""),
            _ when NotANumber().IsMatch(text) => (MeasurementError.NotANumber, ": measure the point again, or leave its line out"),
            _ when Infinite().IsMatch(text) => (MeasurementError.InfiniteNumber, ": measure the point again, or leave its line out"),
            _ when Grouped().IsMatch(text) => (MeasurementError.ThousandsSeparator, " without separators between the thousands"),
            _ when DecimalNumber.TryRead(text, !decimalComma) is not null => decimalComma
                ? (
                    MeasurementError.DecimalPoint,
                    ", for the format says decimal comma: if the file has points, set \"decimalComma\": false in the \"format\" of "
                        + "\"gauge\"")
                : (
                    MeasurementError.DecimalComma,
                    isFixed
                        ? " with a decimal point"
                        : ", for the format says decimal point: if the file has commas, set \"decimalComma\": true in the \"format\" of "
                            + "\"gauge\""),
            _ when IsFormula(text) => (MeasurementError.Formula, ": export values, not formulas"),
            _ => (MeasurementError.TextForNumber, ""),
        };
        return (code, example + advice);
    }

    /// <summary>True if a spreadsheet would interpret the text as a formula. This includes signed numbers, but not a lone dash.</summary>
    public static bool IsFormula(string text) =>
        text.Length > 1 && (text[0] is '=' or '@' || (text[0] is '+' or '-' && text.AsSpan(1).ContainsAnyExcept('-', '+', ' ')));

    [GeneratedRegex(
        @"^[+-]?nan(\(.*\))?$|#QNAN|#SNAN|#IND",
        RegexOptions.IgnoreCase | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex NotANumber();

    [GeneratedRegex(
        @"^[+-]?(inf(inity)?|\u221e)$|#INF",
        RegexOptions.IgnoreCase | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Infinite();

    // A single group after the other decimal separator (1,234) is not a thousand but a decimal: millimeters have three of them.
    [GeneratedRegex(
        @"^[+-]?[0-9]{1,3}(([ '\u2019\u00a0\u202f_][0-9]{3})+([.,][0-9]*)?|(,[0-9]{3}){2,}|(\.[0-9]{3}){2,}"
            + @"|(,[0-9]{3})+\.[0-9]*|(\.[0-9]{3})+,[0-9]*)$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Grouped();
}
