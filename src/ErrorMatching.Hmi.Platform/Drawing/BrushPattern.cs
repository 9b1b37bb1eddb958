using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Converts Avalonia's brushes to Cairo patterns.</summary>
internal static unsafe class BrushPattern
{
    /// <summary>A component of a color, from 0 to 1.</summary>
    public static double Unit(byte v) => v / 255.0;

    /// <summary>A matrix in Cairo's form.</summary>
    public static LibCairo.Mat ToCairo(Matrix m) => new() { Xx = m.M11, Yx = m.M12, Xy = m.M21, Yy = m.M22, X0 = m.M31, Y0 = m.M32 };

    /// <summary>A new pattern for the brush over the target rectangle, or 0 if nothing would be painted.</summary>
    public static nint Of(IBrush? brush, Rect target)
    {
        if (brush is null || brush.Opacity <= 0) return 0;
        nint pattern;
        var toPattern = Matrix.Identity; // from user space to pattern space
        switch (brush)
        {
            case ISolidColorBrush solid:
                if (solid.Color.A == 0) return 0;
                return LibCairo.cairo_pattern_create_rgba(
                    Unit(solid.Color.R), Unit(solid.Color.G), Unit(solid.Color.B), Unit(solid.Color.A) * solid.Opacity);
            case ILinearGradientBrush linear:
                {
                    Point a = linear.StartPoint.ToPixels(target), b = linear.EndPoint.ToPixels(target);
                    pattern = LibCairo.cairo_pattern_create_linear(a.X, a.Y, b.X, b.Y);
                    AddStops(pattern, linear);
                    break;
                }
            case IRadialGradientBrush radial:
                {
                    Point c = radial.Center.ToPixels(target), o = radial.GradientOrigin.ToPixels(target);
                    double rx = Math.Max(1e-6, radial.RadiusX.ToValue(target.Width)),
                        ry = Math.Max(1e-6, radial.RadiusY.ToValue(target.Height));
                    pattern = LibCairo.cairo_pattern_create_radial((o.X - c.X) / rx, (o.Y - c.Y) / ry, 0, 0, 0, 1);
                    AddStops(pattern, radial);
                    toPattern = Matrix.CreateTranslation(-c.X, -c.Y) * Matrix.CreateScale(1 / rx, 1 / ry);
                    break;
                }
            case IConicGradientBrush conic:
                return Conic(conic, target);
            case ISceneBrush scene:
                {
                    using var content = scene.CreateContent();
                    return content is null ? 0 : Tile(content.Brush, content.Rect, target, (context, m) => content.Render(context, m));
                }
            case ISceneBrushContent content:
                return Tile(content.Brush, content.Rect, target, (context, m) => content.Render(context, m));
            case IImageBrush { Source: { } source } image:
                {
                    // The only use of an Avalonia internal: the bitmap behind an image brush (IRef<IBitmapImpl>).
                    var reference = typeof(IImageBrushSource).GetProperty(
                        "Bitmap", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)?.GetValue(source);
                    if (reference?.GetType().GetProperty("Item")?.GetValue(reference) is not CairoBitmap bitmap) return 0;
                    var whole = new Rect(bitmap.PixelSize.ToSize(1));
                    var area = new Rect(bitmap.PixelSize.ToSizeWithDpi(bitmap.Dpi));
                    return Tile(
                        image, area, target, (context, m) => { context.Transform = m; context.DrawBitmap(bitmap, 1, whole, area); });
                }
            default:
                return 0;
        }
        if (brush.Transform is { } t)
        {
            var origin = brush.TransformOrigin.ToPixels(target);
            var m = Matrix.CreateTranslation(-origin.X, -origin.Y) * t.Value * Matrix.CreateTranslation(origin.X, origin.Y);
            if (m.TryInvert(out var inverse)) toPattern = inverse * toPattern;
        }
        LibCairo.cairo_pattern_set_matrix(pattern, ToCairo(toPattern));
        return pattern;
    }

    private static void AddStops(nint pattern, IGradientBrush brush)
    {
        foreach (var stop in brush.GradientStops)
            LibCairo.cairo_pattern_add_color_stop_rgba(
                pattern, stop.Offset, Unit(stop.Color.R), Unit(stop.Color.G), Unit(stop.Color.B), Unit(stop.Color.A) * brush.Opacity);
        LibCairo.cairo_pattern_set_extend(pattern, brush.SpreadMethod switch
        {
            GradientSpreadMethod.Reflect => LibCairo.ExtendReflect,
            GradientSpreadMethod.Repeat => LibCairo.ExtendRepeat,
            _ => LibCairo.ExtendPad,
        });
    }

    /// <summary>Visual, drawing and image brushes: one tile drawn to its own surface.</summary>
    private static nint Tile(ITileBrush brush, Rect content, Rect target, Action<IDrawingContextImpl, Matrix> draw)
    {
        var source = brush.SourceRect.ToPixels(content);
        var place = brush.DestinationRect.ToPixels(target);
        if (source.Width <= 0 || source.Height <= 0 || place.Width <= 0 || place.Height <= 0) return 0;
        var stretch = brush.Stretch.CalculateScaling(place.Size, source.Size);
        var size = new Size(source.Width * stretch.X, source.Height * stretch.Y);
        var x = brush.AlignmentX switch
        {
            AlignmentX.Left => 0,
            AlignmentX.Right => place.Width - size.Width,
            _ => (place.Width - size.Width) / 2
        };
        var y = brush.AlignmentY switch
        {
            AlignmentY.Top => 0,
            AlignmentY.Bottom => place.Height - size.Height,
            _ => (place.Height - size.Height) / 2
        };
        const double detail = 2;
        using var tile = new CairoBitmap(PixelSize.FromSize(place.Size, detail), new Vector(96, 96));
        using (var context = tile.CreateDrawingContext())
        {
            if (brush.Opacity < 1) context.PushOpacity(brush.Opacity, null);
            draw(context, Matrix.CreateTranslation(-source.X, -source.Y) * Matrix.CreateScale(stretch.X * detail, stretch.Y * detail)
                          * Matrix.CreateTranslation(x * detail, y * detail));
            if (brush.Opacity < 1) context.PopOpacity();
        }
        var pattern = LibCairo.cairo_pattern_create_for_surface(tile.Surface); // holds its own reference
        LibCairo.cairo_pattern_set_extend(
            pattern,
            brush.TileMode switch
            {
                TileMode.None => LibCairo.ExtendNone,
                TileMode.Tile => LibCairo.ExtendRepeat,
                _ => LibCairo.ExtendReflect
            });
        LibCairo.cairo_pattern_set_matrix(
            pattern, ToCairo(Matrix.CreateTranslation(-place.X, -place.Y) * Matrix.CreateScale(detail, detail)));
        return pattern;
    }

    /// <summary>Cairo has no conic gradients: they are colored pixel by pixel, clockwise from the top.</summary>
    private static nint Conic(IConicGradientBrush brush, Rect target)
    {
        var stops = brush.GradientStops.OrderBy(s => s.Offset).ToArray();
        if (stops.Length == 0 || target.Width < 1 || target.Height < 1) return 0;
        using var image = new CairoBitmap(PixelSize.FromSize(target.Size, 1), new Vector(96, 96));
        var center = brush.Center.ToPixels(target) - target.TopLeft;
        using (var pixels = image.Lock())
            for (var y = 0; y < image.PixelSize.Height; y++)
                for (var x = 0; x < image.PixelSize.Width; x++)
                {
                    var turn = Math.Atan2(x + 0.5 - center.X, center.Y - y - 0.5) / (2 * Math.PI) - brush.Angle / 360;
                    turn -= Math.Floor(turn);
                    var next = Array.FindIndex(stops, s => s.Offset >= turn);
                    var (a, b) = next < 0 ? (stops[^1], stops[^1]) : (stops[Math.Max(0, next - 1)], stops[next]);
                    var f = b.Offset > a.Offset ? (turn - a.Offset) / (b.Offset - a.Offset) : 0;
                    double Mix(byte from, byte to) => from + (to - from) * f;
                    var alpha = Mix(a.Color.A, b.Color.A) * brush.Opacity / 255;
                    var p = (byte*)pixels.Address + y * pixels.RowBytes + x * 4;
                    p[0] = (byte)(Mix(a.Color.B, b.Color.B) * alpha);
                    p[1] = (byte)(Mix(a.Color.G, b.Color.G) * alpha);
                    p[2] = (byte)(Mix(a.Color.R, b.Color.R) * alpha);
                    p[3] = (byte)(alpha * 255);
                }
        var pattern = LibCairo.cairo_pattern_create_for_surface(image.Surface);
        LibCairo.cairo_pattern_set_extend(pattern, LibCairo.ExtendPad);
        LibCairo.cairo_pattern_set_matrix(pattern, ToCairo(Matrix.CreateTranslation(-target.X, -target.Y)));
        return pattern;
    }
}
