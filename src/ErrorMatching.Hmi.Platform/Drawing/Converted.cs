using Avalonia;
using Avalonia.Media;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Converts Avalonia's values to Skia's.</summary>
internal static class Converted
{
    public static SKPoint ToSkia(this Point p) => new((float)p.X, (float)p.Y);

    public static SKPoint ToSkia(this Vector v) => new((float)v.X, (float)v.Y);

    public static SKRect ToSkia(this Rect r) => new((float)r.X, (float)r.Y, (float)r.Right, (float)r.Bottom);

    public static Rect ToAvalonia(this SKRect r) => new(r.Left, r.Top, r.Width, r.Height);

    public static SKMatrix ToSkia(this Matrix m) => new(
        (float)m.M11, (float)m.M21, (float)m.M31, (float)m.M12, (float)m.M22, (float)m.M32, (float)m.M13, (float)m.M23, (float)m.M33);

    public static SKColor ToSkia(this Color c, double opacity = 1) => new(c.R, c.G, c.B, (byte)Math.Round(c.A * Math.Clamp(opacity, 0, 1)));

    public static SKPathFillType ToSkia(this FillRule rule) =>
        rule == FillRule.EvenOdd ? SKPathFillType.EvenOdd : SKPathFillType.Winding;

    /// <summary>Sets a rounded rectangle. Radii that do not fit are scaled down together, as in CSS.</summary>
    public static SKRoundRect Set(this SKRoundRect target, RoundedRect rect)
    {
        target.SetRectRadii(
            rect.Rect.ToSkia(),
            [rect.RadiiTopLeft.ToSkia(), rect.RadiiTopRight.ToSkia(), rect.RadiiBottomRight.ToSkia(), rect.RadiiBottomLeft.ToSkia()]);
        return target;
    }
}
