using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>Lengths in micrometres as reports show them: two decimals, never a negative zero.</summary>
internal static class Micrometres
{
    /// <summary>A size.</summary>
    public static string Plain(double um) => um.ToString("0.00;-0.00;0.00", CultureInfo.InvariantCulture);

    /// <summary>A deviation, whose sign matters.</summary>
    public static string Signed(double um) => um.ToString("+0.0;-0.0;0.0", CultureInfo.InvariantCulture);

    /// <summary>A size given in millimetres.</summary>
    public static string OfMm(double mm) => Plain(mm * 1000);

    /// <summary>A deviation given in millimetres.</summary>
    public static string SignedOfMm(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);
}
