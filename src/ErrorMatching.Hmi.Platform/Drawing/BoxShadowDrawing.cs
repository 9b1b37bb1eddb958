using Avalonia;
using Avalonia.Media;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Box shadows: a blurred box, clipped to the outside or to the inside of the box that casts it. The blur is that of CSS
/// Backgrounds 3: a Gaussian whose standard deviation is half of the blur radius.</summary>
internal static class BoxShadowDrawing
{
    /// <summary>Draws a shadow.</summary>
    public static void Draw(SKCanvas canvas, SKPaint paint, BoxShadow shadow, RoundedRect box)
    {
        using var blur = shadow.Blur > 0 ? SKMaskFilter.CreateBlur(SKBlurStyle.Normal, (float)shadow.Blur / 2) : null;
        using var edge = new SKRoundRect().Set(box);
        using var cast = new SKRoundRect().Set(
            shadow.IsInset ? box.Deflate(shadow.Spread, shadow.Spread) : box.Inflate(shadow.Spread, shadow.Spread));
        cast.Offset((float)shadow.OffsetX, (float)shadow.OffsetY);
        paint.Color = shadow.Color.ToSkia();
        paint.MaskFilter = blur;
        canvas.Save();
        canvas.ClipRoundRect(edge, shadow.IsInset ? SKClipOperation.Intersect : SKClipOperation.Difference, antialias: true);
        if (shadow.IsInset)
        {
            // What casts the shadow is everything around the opening.
            var far = (float)((2 * shadow.Blur) + Math.Abs(shadow.OffsetX) + Math.Abs(shadow.OffsetY) + Math.Abs(shadow.Spread) + 1);
            var around = edge.Rect;
            around.Inflate(far, far);
            using var outer = new SKRoundRect(around);
            canvas.DrawRoundRectDifference(outer, cast, paint);
        }
        else
        {
            canvas.DrawRoundRect(cast, paint);
        }

        canvas.Restore();
    }
}
