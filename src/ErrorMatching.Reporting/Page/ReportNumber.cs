using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>Numbers as reports show them: a fixed number of decimals, so that those of a column stand under each other, never a negative zero.</summary>
public static class ReportNumber
{
    /// <summary>What stands where there is no number.</summary>
    public const string None = "–";

    /// <summary>A coordinate, a length in mm or an angle in degrees: three decimals.</summary>
    public static string Plain(double value) => Format(value, "0.000;-0.000;0.000");

    /// <summary>A deviation, whose sign matters: three decimals.</summary>
    public static string Signed(double value) => Format(value, "+0.000;-0.000;0.000");

    /// <summary>An uncertainty or a residual, smaller than the last digit of a coordinate: four decimals.</summary>
    public static string Fine(double value) => Format(value, "0.0000;-0.0000;0.0000");

    /// <summary>A deviation in mm within a sentence.</summary>
    public static string SignedMm(double value) => Signed(value) + " mm";

    /// <summary>A share in percent.</summary>
    public static string Percent(double value) => Format(value, "+0.0;-0.0;0.0");

    /// <summary>A duration in seconds.</summary>
    public static string Seconds(double value) => Format(value, "0.000");

    /// <summary>As short as it can be said.</summary>
    public static string Short(double value) => Format(value + 0.0, "G9");

    /// <summary>A number of which only the size matters.</summary>
    public static string Rough(double value) => Format(value + 0.0, "G3");

    /// <summary>A number of things.</summary>
    public static string Count(int value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>A number of things with their name, which takes an s.</summary>
    public static string Count(int value, string thing) => $"{Count(value)} {thing}{(value == 1 ? "" : "s")}";

    private static string Format(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
