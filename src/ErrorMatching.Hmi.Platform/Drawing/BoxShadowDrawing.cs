using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Box shadows: Cairo does not support them, so a mask is blurred.</summary>
internal static unsafe class BoxShadowDrawing
{
    /// <summary>Draws the shadow of a box, only outside the box.</summary>
    public static void Draw(nint target, BoxShadow shadow, RoundedRect rect)
    {
        var shape = rect.Inflate(shadow.Spread, shadow.Spread);
        var margin = shadow.Blur + 2;
        var area = shape.Rect.Inflate(margin);
        var mask = LibCairo.cairo_image_surface_create(LibCairo.FormatA8, (int)Math.Ceiling(area.Width), (int)Math.Ceiling(area.Height));
        var cr = LibCairo.cairo_create(mask);
        LibCairo.cairo_set_matrix(cr, BrushPattern.ToCairo(Matrix.CreateTranslation(-area.X, -area.Y)));
        CairoGeometry.Rounded(shape).AddTo(cr);
        LibCairo.cairo_fill(cr);
        LibCairo.cairo_destroy(cr);
        LibCairo.cairo_surface_flush(mask);
        Blur(
            LibCairo.cairo_image_surface_get_data(mask),
            LibCairo.cairo_image_surface_get_width(mask),
            LibCairo.cairo_image_surface_get_height(mask),
            LibCairo.cairo_image_surface_get_stride(mask), (int)Math.Round(shadow.Blur / 2));
        LibCairo.cairo_surface_mark_dirty(mask);
        LibCairo.cairo_save(target);

        // The shadow is visible only outside the box.
        LibCairo.cairo_new_path(target);
        new CairoGeometry
        {
            FillRule = FillRule.EvenOdd,
            Segments = [
                .. CairoGeometry.Rectangle(area.Inflate(Math.Abs(shadow.OffsetX) + Math.Abs(shadow.OffsetY))).Segments,
                .. CairoGeometry.Rounded(rect).Segments]
        }.AddTo(target);
        LibCairo.cairo_clip(target);
        LibCairo.cairo_set_source_rgba(
            target,
            BrushPattern.Unit(shadow.Color.R),
            BrushPattern.Unit(shadow.Color.G),
            BrushPattern.Unit(shadow.Color.B),
            BrushPattern.Unit(shadow.Color.A));
        LibCairo.cairo_mask_surface(target, mask, area.X + shadow.OffsetX, area.Y + shadow.OffsetY);
        LibCairo.cairo_restore(target);
        LibCairo.cairo_surface_destroy(mask);
    }

    /// <summary>Three box blurs: close to a Gaussian.</summary>
    private static void Blur(byte* data, int width, int height, int stride, int radius)
    {
        if (radius < 1) return;
        var line = new byte[Math.Max(width, height)];
        void Pass(byte* start, int count, int step)
        {
            int sum = 0, window = 2 * radius + 1;
            byte At(int i) => i < 0 || i >= count ? (byte)0 : start[i * step];
            for (var i = -radius; i <= radius; i++) sum += At(i);
            for (var i = 0; i < count; i++)
            {
                line[i] = (byte)(sum / window);
                sum += At(i + radius + 1) - At(i - radius);
            }
            for (var i = 0; i < count; i++) start[i * step] = line[i];
        }
        for (var n = 0; n < 2; n++)
        {
            for (var y = 0; y < height; y++) Pass(data + y * stride, width, 1);
            for (var x = 0; x < width; x++) Pass(data + x, height, stride);
        }
    }
}
