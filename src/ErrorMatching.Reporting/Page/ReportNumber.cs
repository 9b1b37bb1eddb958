using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>Formats numbers for reports: a fixed number of decimals, so that columns align, and no negative zero.</summary>
public static class ReportNumber
{
    /// <summary>Placeholder for a missing number.</summary>
    public const string None = "–";

    /// <summary>A coordinate, a length in mm or an angle in degrees: three decimals.</summary>
    public static string Plain(double value) => Format(value, "0.000;-0.000;0.000");

    /// <summary>A signed deviation: three decimals.</summary>
    public static string Signed(double value) => Format(value, "+0.000;-0.000;0.000");

    /// <summary>An uncertainty or a residual, which is smaller than the last digit of a coordinate: four decimals.</summary>
    public static string Fine(double value) => Format(value, "0.0000;-0.0000;0.0000");

    /// <summary>A deviation in mm within a sentence.</summary>
    public static string SignedMm(double value) => Signed(value) + " mm";

    /// <summary>A signed error with half its 95 % interval, four decimals each: <c>-0.0014 ± 0.0106</c>; alone if the interval is not
    /// known.</summary>
    public static string Interval(double value, double? half) =>
        Format(value, "+0.0000;-0.0000;0.0000") + (half is { } h ? " ± " + Fine(h) : "");

    /// <summary>A signed share in percent, with one decimal; 100 only where nothing is left.</summary>
    public static string Percent(double percent) => Format(ShortOfAll(percent), "+0.0;-0.0;0.0");

    /// <summary>A share in whole percent, with a decimal between 99 and 100: 100 only where nothing is left.</summary>
    public static string WholePercent(double percent) =>
        Math.Abs(percent) is > 99 and < 100 ? Format(ShortOfAll(percent), "0.0;-0.0") : Format(percent, "0;-0;0");

    // What would round to all is cut off instead.
    private static double ShortOfAll(double percent) =>
        Math.Abs(percent) is > 99 and < 100 ? Math.Round(percent, 1, MidpointRounding.ToZero) : percent;

    /// <summary>A probability in percent, with one decimal; next to 0 and 1, <c>less than</c> or <c>more than</c> a bound.</summary>
    public static string Probability(double value) => (value * 100) switch
    {
        < 0.1 => "less than 0.1 %",
        > 99.9 => "more than 99.9 %",
        var percent => Format(percent, "0.0") + " %",
    };

    /// <summary>A duration in seconds, with three decimals.</summary>
    public static string Seconds(double value) => Format(value, "0.000");

    /// <summary>The shortest form, with up to nine digits.</summary>
    public static string Short(double value) => Format(value + 0.0, "G9");

    /// <summary>A number with up to three digits, if only its magnitude matters.</summary>
    public static string Rough(double value) => Format(value + 0.0, "G3");

    /// <summary>A count.</summary>
    public static string Count(int value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>A count with a noun, which takes an s in the plural.</summary>
    public static string Count(int value, string thing) => Count(value, thing, thing + "s");

    /// <summary>A count with what is counted, as one and as several.</summary>
    public static string Count(int value, string one, string several) => $"{Count(value)} {(value == 1 ? one : several)}";

    private static string Format(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
