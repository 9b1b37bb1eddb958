using System.Globalization;

namespace ErrorMatching.Measurement;

/// <summary>Numbers as the results of a piece have them.</summary>
internal static class WrittenNumber
{
    /// <summary>Decimals of a millimeter: a nanometer, finer than any gauge.</summary>
    public const int Decimals = 6;

    /// <summary>A length in millimeters.</summary>
    public static string Of(double mm)
    {
        // Adding 0 turns a negative zero into zero.
        return (Math.Round(mm, Decimals) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);
    }

    /// <summary>A component of a unit vector.</summary>
    public static string OfUnit(double component) =>
        (Math.Round(component, 12) + 0.0).ToString("0.############", CultureInfo.InvariantCulture);
}
