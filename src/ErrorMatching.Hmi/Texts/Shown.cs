using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Formats numbers and times for display: fixed decimals, so that columns align; deviations have their sign.</summary>
public static class Shown
{
    // A real minus sign is as wide as the plus sign; a hyphen is not.
    private const string MillimetersFormat = "0.0000;−0.0000";
    private const string SignedFormat = "+0.0000;−0.0000;0.0000";
    private const string DegreesFormat = MillimetersFormat;
    private const string MicrometersFormat = "0.00;−0.00";
    private const string SignedMicrometersFormat = "+0.00;−0.00;0.00";
    private const string SignedDegreesFormat = SignedFormat;

    // An error and its interval stay on one line.
    private const string Between = "\u00a0±\u00a0";

    /// <summary>Placeholder for a missing value.</summary>
    public const string Nothing = "–";

    /// <summary>A length or coordinate in mm, four decimals.</summary>
    public static string Mm(double? mm) => Number(mm, MillimetersFormat);

    /// <summary>A deviation in mm with its sign, four decimals.</summary>
    public static string SignedMm(double? mm) => Number(mm, SignedFormat);

    /// <summary>An error in mm with its sign and half its 95 % interval, four decimals each; alone if the interval is not known.</summary>
    public static string SignedMm(double mm, double? interval95Mm) => SignedMm(mm) + Within(interval95Mm);

    /// <summary>The size of an error in mm with half its 95 % interval, four decimals each; alone if the interval is not known.</summary>
    public static string Mm(double mm, double? interval95Mm) => Mm(mm) + Within(interval95Mm);

    /// <summary>The size of an error in a sentence with half its 95 % interval, to two digits of that, as a report prints it: an error is
    /// not known better.</summary>
    public static string MmAsKnown(double mm, double? interval95Mm)
    {
        var format = interval95Mm is < 0.00995 ? "0.0000" : "0.000";
        return Number(Math.Abs(mm), format) + (interval95Mm is { } half ? Between + Number(half, format) : "");
    }

    /// <summary>An angle in degrees, four decimals like the lengths above and below it.</summary>
    public static string Degrees(double? degrees) => Number(degrees, DegreesFormat);

    /// <summary>A difference of angles in degrees with its sign, four decimals.</summary>
    public static string SignedDegrees(double? degrees) => Number(degrees, SignedDegreesFormat);

    /// <summary>A length in mm as micrometers, two decimals.</summary>
    public static string Micrometers(double? mm) => Number(1000 * mm, MicrometersFormat);

    /// <summary>A deviation in mm as micrometers with its sign, two decimals.</summary>
    public static string SignedMicrometers(double? mm) => Number(1000 * mm, SignedMicrometersFormat);

    /// <summary>A deviation in mm as micrometers with its sign, two digits, for narrow places.</summary>
    public static string ShortMicrometers(double mm) =>
        Math.Abs(mm) < 0.00995 ? Number(1000 * mm, "+0.0;−0.0;0.0") : (1000 * mm).ToString("+0;−0", CultureInfo.InvariantCulture);

    /// <summary>A number without a unit, with up to three decimals.</summary>
    public static string Number(double value) => value.ToString("0.###;−0.###", CultureInfo.InvariantCulture);

    /// <summary>A percentage; 100 only where nothing is left.</summary>
    public static string Percent(double? percent) =>
        percent is { } p ? ReportNumber.WholePercent(p).Replace('-', '−') + " %" : Nothing;

    /// <summary>A percentage with one decimal.</summary>
    public static string FinePercent(double percent) => Number(percent, "0.0;−0.0") + " %";

    /// <summary>A count.</summary>
    public static string Count(long count) => count.ToString("#,##0", CultureInfo.InvariantCulture);

    /// <summary>Number of a correction or of an entry.</summary>
    public static string Id(long id) => id.ToString(CultureInfo.InvariantCulture);

    /// <summary>A time in the computer's time zone, in the format of the language, to the second.</summary>
    public static string Time(DateTimeOffset time, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(clock);
        return TimeZoneInfo.ConvertTime(time, clock.LocalTimeZone).ToString(Texts.Current["Format.Time"], CultureInfo.InvariantCulture);
    }

    /// <summary>A time of day in the computer's time zone, to the minute.</summary>
    public static string TimeOfDay(DateTimeOffset time, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(clock);
        return TimeZoneInfo.ConvertTime(time, clock.LocalTimeZone).ToString("HH:mm", CultureInfo.InvariantCulture);
    }

    private static string Within(double? interval95Mm) => interval95Mm is { } half ? Between + Mm(half) : "";

    // A value that rounds to zero has no sign.
    private static string Number(double? value, string format) => value is { } v
        ? (Math.Round(v, format.Split(';')[0].Count(c => c == '0') - 1) + 0.0).ToString(format, CultureInfo.InvariantCulture)
        : Nothing;
}
