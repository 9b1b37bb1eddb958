using Avalonia.Media;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Converts Avalonia's pens to Skia's paint.</summary>
internal static class PenPaint
{
    /// <summary>Sets everything of a stroke but its color.</summary>
    public static void Set(SKPaint paint, IPen pen)
    {
        paint.Style = SKPaintStyle.Stroke;
        paint.StrokeWidth = (float)pen.Thickness;
        paint.StrokeCap = pen.LineCap switch
        {
            PenLineCap.Round => SKStrokeCap.Round,
            PenLineCap.Square => SKStrokeCap.Square,
            _ => SKStrokeCap.Butt,
        };
        paint.StrokeJoin = pen.LineJoin switch
        {
            PenLineJoin.Round => SKStrokeJoin.Round,
            PenLineJoin.Bevel => SKStrokeJoin.Bevel,
            _ => SKStrokeJoin.Miter,
        };
        paint.StrokeMiter = (float)pen.MiterLimit;
        if (pen.DashStyle?.Dashes is { Count: > 0 } dashes)
        {
            // Lengths are in thicknesses; an odd number of them is repeated.
            var lengths = dashes.Concat(dashes.Count % 2 == 0 ? [] : dashes).Select(d => (float)(d * pen.Thickness)).ToArray();
            if (lengths.All(l => l >= 0) && lengths.Sum() > 0)
            {
                using var effect = SKPathEffect.CreateDash(lengths, (float)(pen.DashStyle.Offset * pen.Thickness));
                paint.PathEffect = effect;
            }
        }
    }
}
