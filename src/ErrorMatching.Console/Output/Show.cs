using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>Number formats in text for people. Scripts read JSON, which has all digits.</summary>
internal static class Show
{
    /// <summary>A length in millimeters, to a tenth of a micrometer; no sign if it rounds to zero.</summary>
    public static string Mm(double value) => value.ToString("0.0000;-0.0000;0.0000", CultureInfo.InvariantCulture);

    /// <summary>A directed length in millimeters, with its sign; no sign if it rounds to zero.</summary>
    public static string Signed(double value) => value.ToString("+0.0000;-0.0000;0.0000", CultureInfo.InvariantCulture);

    /// <summary>A proportion in percent.</summary>
    public static string Percent(double value) => ReportNumber.WholePercent(value) + " %";

    /// <summary>An angle in degrees, to a ten-thousandth.</summary>
    public static string Degrees(double value) => value.ToString("0.0000", CultureInfo.InvariantCulture);

    /// <summary>A quantity of unknown magnitude, to six digits.</summary>
    public static string Digits(double value) => value.ToString("G6", CultureInfo.InvariantCulture);

    /// <summary>As many digits as distinguish the number from its neighbors.</summary>
    public static string Exact(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
