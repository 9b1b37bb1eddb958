using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Reporting;

/// <summary>Colors for signed values: blue below zero, nearly white at zero, orange above; readable if red-green color-blind.</summary>
/// <remarks>In both directions from zero, lightness decreases and colorfulness increases evenly in Oklab (B. Ottosson, "A perceptual color
/// space for image processing", 2020), so that equal steps of the value look equal.</remarks>
public static class DivergingColors
{
    /// <summary>Number of colors: odd, so that one of them represents zero.</summary>
    public const int Count = 21;

    private const double LightnessAtZero = 0.97, LightnessAtEnd = 0.42, ChromaAtEnd = 0.13, BlueHueDegrees = 255, OrangeHueDegrees = 50;

    // On a dark page, zero is a little lighter than the page, and the ends are light.
    private const double DarkLightnessAtZero = 0.28, DarkLightnessAtEnd = 0.8;

    /// <summary>The color index of a value: 0 for the lowest, <see cref="Count"/> - 1 for the highest.</summary>
    /// <param name="value">The value.</param>
    /// <param name="limit">The absolute value of the last color, which is also used beyond.</param>
    public static int IndexOf(double value, double limit) =>
        (int)Math.Clamp(Math.Round(((value / limit) + 1) / 2 * (Count - 1), MidpointRounding.AwayFromZero), 0, Count - 1);

    /// <summary>A color as <c>#rrggbb</c>.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1.</param>
    public static string Hex(int index) => HexAt(((2.0 * index) / (Count - 1)) - 1);

    /// <summary>The color of a share of the limit as <c>#rrggbb</c>.</summary>
    /// <param name="share">-1 to 1.</param>
    public static string HexAt(double share) => Hex(share, LightnessAtZero, LightnessAtEnd);

    /// <summary>The color for a dark page: dark at zero, and lighter towards the ends.</summary>
    /// <param name="share">-1 to 1.</param>
    public static string DarkHexAt(double share) => Hex(share, DarkLightnessAtZero, DarkLightnessAtEnd);

    private static string Hex(double share, double atZero, double atEnd)
    {
        var lightness = atZero + ((atEnd - atZero) * Math.Abs(share));
        var (sin, cos) = Elementary.SinCos((share < 0 ? BlueHueDegrees : OrangeHueDegrees) * Math.PI / 180);
        var chroma = ChromaAtEnd * Math.Abs(share);
        var (r, g, b) = ToRgb(lightness, chroma * cos, chroma * sin);
        return string.Create(CultureInfo.InvariantCulture, $"#{Byte(r):x2}{Byte(g):x2}{Byte(b):x2}");
    }

    // Oklab to linear sRGB, with the author's matrices.
    private static (double R, double G, double B) ToRgb(double lightness, double a, double b)
    {
        var l = Cube(lightness + (0.3963377774 * a) + (0.2158037573 * b));
        var m = Cube(lightness - (0.1055613458 * a) - (0.0638541728 * b));
        var s = Cube(lightness - (0.0894841775 * a) - (1.2914855480 * b));
        return (
            (4.0767416621 * l) - (3.3077115913 * m) + (0.2309699292 * s),
            (-1.2684380046 * l) + (2.6097574011 * m) - (0.3413193965 * s),
            (-0.0041960863 * l) - (0.7034186147 * m) + (1.7076147010 * s));
    }

    private static double Cube(double x) => x * x * x;

    // The transfer function of sRGB.
    private static int Byte(double linear)
    {
        var value = Math.Clamp(linear, 0, 1);
        return (int)Math.Round(255 * (value <= 0.0031308 ? 12.92 * value : (1.055 * Elementary.Pow(value, 1 / 2.4)) - 0.055));
    }
}
