using System.Reflection;
using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Converts Avalonia's brushes to Skia's paint.</summary>
internal static class BrushPaint
{
    private const string BitmapReference = "Avalonia.Utilities.IRef`1[[Avalonia.Platform.IBitmapImpl, Avalonia.Base]], Avalonia.Base";

    /// <summary>Sets the color or the shader of a brush over a rectangle.</summary>
    /// <returns>False if nothing would be painted.</returns>
    public static bool Set(SKPaint paint, IBrush? brush, Rect target)
    {
        if (brush is null || brush.Opacity <= 0)
        {
            return false;
        }

        if (brush is ISolidColorBrush solid)
        {
            paint.Color = solid.Color.ToSkia(solid.Opacity);
            return paint.Color.Alpha > 0;
        }

        using var shader = brush switch
        {
            IGradientBrush gradient => Gradient(gradient, target),
            ISceneBrush scene => Scene(scene, target),
            ISceneBrushContent content => Tile(content.Brush, content.Rect, target, (context, m) => content.Render(context, m)),
            IImageBrush { Source: { } source } image => Image(image, source, target),
            _ => null,
        };
        if (shader is null)
        {
            return false;
        }

        paint.Color = Colors.Black.ToSkia(brush.Opacity);
        paint.Shader = shader;
        return true;
    }

    private static SKShader? Gradient(IGradientBrush brush, Rect target)
    {
        var stops = brush.GradientStops.OrderBy(s => s.Offset).ToArray();
        if (stops.Length == 0)
        {
            return null;
        }

        var (colors, places) = (stops.Select(s => s.Color.ToSkia()).ToArray(), stops.Select(s => (float)s.Offset).ToArray());
        var beyond = brush.SpreadMethod switch
        {
            GradientSpreadMethod.Reflect => SKShaderTileMode.Mirror,
            GradientSpreadMethod.Repeat => SKShaderTileMode.Repeat,
            _ => SKShaderTileMode.Clamp,
        };
        switch (brush)
        {
            case ILinearGradientBrush linear:
                return SKShader.CreateLinearGradient(
                    linear.StartPoint.ToPixels(target).ToSkia(),
                    linear.EndPoint.ToPixels(target).ToSkia(),
                    colors,
                    places,
                    beyond,
                    Transform(brush, target).ToSkia());
            case IRadialGradientBrush radial:
                // A circle of radius 1 about the center, stretched.
                var (center, origin) = (radial.Center.ToPixels(target), radial.GradientOrigin.ToPixels(target));
                var rx = Math.Max(1e-6, radial.RadiusX.ToValue(target.Width));
                var ry = Math.Max(1e-6, radial.RadiusY.ToValue(target.Height));
                return SKShader.CreateTwoPointConicalGradient(
                    new Point((origin.X - center.X) / rx, (origin.Y - center.Y) / ry).ToSkia(),
                    0,
                    default,
                    1,
                    colors,
                    places,
                    beyond,
                    (Matrix.CreateScale(rx, ry) * Matrix.CreateTranslation(center.X, center.Y) * Transform(brush, target)).ToSkia());
            case IConicGradientBrush conic:
                // Skia begins at the right, Avalonia at the top.
                var middle = conic.Center.ToPixels(target);
                return SKShader.CreateSweepGradient(
                    default,
                    colors,
                    places,
                    (Matrix.CreateRotation(Matrix.ToRadians(conic.Angle - 90)) * Matrix.CreateTranslation(middle.X, middle.Y)
                        * Transform(brush, target)).ToSkia());
            default:
                return null;
        }
    }

    private static Matrix Transform(IBrush brush, Rect target)
    {
        if (brush.Transform is not { } transform)
        {
            return Matrix.Identity;
        }

        var origin = brush.TransformOrigin.ToPixels(target);
        return Matrix.CreateTranslation(-origin.X, -origin.Y) * transform.Value * Matrix.CreateTranslation(origin.X, origin.Y);
    }

    private static SKShader? Scene(ISceneBrush scene, Rect target)
    {
        using var content = scene.CreateContent();
        return content is null ? null : Tile(content.Brush, content.Rect, target, (context, m) => content.Render(context, m));
    }

    private static SKShader? Image(IImageBrush brush, IImageBrushSource source, Rect target)
    {
        // The only use of an Avalonia internal: the bitmap behind an image brush. Both properties are named with their types, or a trimmed
        // program would lack them.
        var reference = typeof(IImageBrushSource).GetProperty("Bitmap", BindingFlags.Instance | BindingFlags.NonPublic)?.GetValue(source);
        if (reference is null || Type.GetType(BitmapReference)?.GetProperty("Item")?.GetValue(reference) is not SkiaBitmap bitmap)
        {
            return null;
        }

        var (whole, area) = (new Rect(bitmap.PixelSize.ToSize(1)), new Rect(bitmap.PixelSize.ToSizeWithDpi(bitmap.Dpi)));
        return Tile(
            brush,
            area,
            target,
            (context, m) =>
            {
                context.Transform = m;
                context.DrawBitmap(bitmap, 1, whole, area);
            });
    }

    // Visual, drawing and image brushes: one tile, recorded and repeated.
    private static SKShader? Tile(ITileBrush brush, Rect content, Rect target, Action<IDrawingContextImpl, Matrix> draw)
    {
        var (source, place) = (brush.SourceRect.ToPixels(content), brush.DestinationRect.ToPixels(target));
        if (source.Width <= 0 || source.Height <= 0 || place.Width <= 0 || place.Height <= 0)
        {
            return null;
        }

        var stretch = brush.Stretch.CalculateScaling(place.Size, source.Size);
        var room = place.Size - new Size(source.Width * stretch.X, source.Height * stretch.Y);
        var x = brush.AlignmentX switch { AlignmentX.Left => 0, AlignmentX.Right => room.Width, _ => room.Width / 2 };
        var y = brush.AlignmentY switch { AlignmentY.Top => 0, AlignmentY.Bottom => room.Height, _ => room.Height / 2 };
        var tile = new Rect(place.Size).ToSkia();
        using var recorder = new SKPictureRecorder();
        using (var context = new SkiaContext(recorder.BeginRecording(tile), 1) { IsCanvasKept = true })
        {
            draw(
                context,
                Matrix.CreateTranslation(-source.X, -source.Y)
                    * Matrix.CreateScale(stretch.X, stretch.Y)
                    * Matrix.CreateTranslation(x, y));
        }

        using var picture = recorder.EndRecording();
        return picture.ToShader(
            Repeated(brush.TileMode is TileMode.FlipX or TileMode.FlipXY, brush.TileMode),
            Repeated(brush.TileMode is TileMode.FlipY or TileMode.FlipXY, brush.TileMode),
            SKFilterMode.Linear,
            (Matrix.CreateTranslation(place.X, place.Y) * Transform(brush, target)).ToSkia(),
            tile);
    }

    private static SKShaderTileMode Repeated(bool isFlipped, TileMode mode) =>
        mode == TileMode.None ? SKShaderTileMode.Decal : isFlipped ? SKShaderTileMode.Mirror : SKShaderTileMode.Repeat;
}
