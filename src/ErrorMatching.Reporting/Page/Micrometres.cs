using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>Formats lengths in micrometers for reports, without a negative zero.</summary>
public static class Micrometres
{
    /// <summary>A size, with two decimals.</summary>
    public static string Plain(double um) => um.ToString("0.00;-0.00;0.00", CultureInfo.InvariantCulture);

    /// <summary>A signed deviation, with one decimal.</summary>
    public static string Signed(double um) => um.ToString("+0.0;-0.0;0.0", CultureInfo.InvariantCulture);

    /// <summary>A size given in millimeters, with two decimals.</summary>
    public static string OfMm(double mm) => Plain(mm * 1000);

    /// <summary>A signed deviation given in millimeters, with two decimals.</summary>
    public static string SignedOfMm(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);
}
