using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Formats places for messages, in millimeters. It avoids negative zeros, and writes very large values by magnitude instead of
/// hundreds of digits.</summary>
internal static class PlaceText
{
    private const double Far = 1e9;

    /// <summary>A place in the style of a control: <c>X1.5 Y0 Z-2</c>.</summary>
    public static string Words(Point3 p, int decimals = 3) => $"X{Mm(p.X, decimals)} Y{Mm(p.Y, decimals)} Z{Mm(p.Z, decimals)}";

    /// <summary>A place in the style of a drawing: <c>(1.5, 0, -2)</c>.</summary>
    public static string Triple(Point3 p) => $"({Mm(p.X, 3)}, {Mm(p.Y, 3)}, {Mm(p.Z, 3)})";

    /// <summary>A length or coordinate with at most the given number of decimals.</summary>
    public static string Mm(double value, int decimals) => Math.Abs(value) >= Far
        ? double.IsFinite(value) ? value.ToString("0.###E+0", CultureInfo.InvariantCulture) : "more than 1E+150"
        : (Math.Round(value, decimals) + 0.0).ToString("0." + new string('#', decimals), CultureInfo.InvariantCulture);
}
