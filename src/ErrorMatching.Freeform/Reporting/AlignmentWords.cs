using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>The text of reports about an alignment.</summary>
public static class AlignmentWords
{
    /// <summary>A sentence that states whether measured points were moved before the comparison, and how far.</summary>
    /// <param name="alignment">The alignment; null for none.</param>
    public static string Of(SurfaceAlignment? alignment) => alignment is { } a
        ? string.Create(
            CultureInfo.InvariantCulture,
            $"Best fit: moved by X{a.TranslateMm.X:0.0000} Y{a.TranslateMm.Y:0.0000} Z{a.TranslateMm.Z:0.0000} mm, turned by "
                + $"{a.RotateDegrees.Length:0.00000}°.")
        : "None: points are compared where they were measured.";
}
