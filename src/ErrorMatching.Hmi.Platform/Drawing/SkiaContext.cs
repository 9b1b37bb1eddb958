using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Avalonia's drawing operations over a canvas.</summary>
internal sealed class SkiaContext : IDrawingContextImpl
{
    private readonly SKCanvas _canvas;
    private readonly SKPaint _paint = new();
    private readonly SKRoundRect _rounded = new();
    private readonly Matrix _post;
    private readonly Stack<Level> _levels = new();
    private readonly Stack<RenderOptions> _options = new();
    private Matrix _transform = Matrix.Identity;

    /// <summary>Begins to draw.</summary>
    /// <param name="canvas">Where to; disposed of at the end unless <see cref="IsCanvasKept"/>.</param>
    /// <param name="scale">Pixels per unit.</param>
    public SkiaContext(SKCanvas canvas, double scale)
    {
        _canvas = canvas;
        _post = Matrix.CreateScale(scale, scale);
        Transform = Matrix.Identity;
    }

    /// <summary>Called when everything is drawn.</summary>
    public Action? Finished { get; init; }

    /// <summary>Records which pixels are drawn on; null if nobody wants to know.</summary>
    public Damage? Damage { get; init; }

    /// <summary>True if somebody else owns the canvas.</summary>
    public bool IsCanvasKept { get; init; }

    public Matrix Transform
    {
        get => _transform;
        set
        {
            _transform = value;
            var matrix = (value * _post).ToSkia();
            _canvas.SetMatrix(in matrix);
        }
    }

    private bool IsSmooth => !(_options.TryPeek(out var o) && o.EdgeMode == EdgeMode.Aliased);

    public void Dispose()
    {
        _paint.Dispose();
        _rounded.Dispose();
        if (!IsCanvasKept)
        {
            _canvas.Dispose();
        }

        Finished?.Invoke();
    }

    public void Clear(Color color)
    {
        Touch();
        _canvas.Clear(color.ToSkia());
    }

    public void DrawLine(IPen? pen, Point p1, Point p2)
    {
        if (IsStroked(pen, new Rect(p1, p2).Normalize()))
        {
            _canvas.DrawLine(p1.ToSkia(), p2.ToSkia(), _paint);
        }
    }

    public void DrawGeometry(IBrush? brush, IPen? pen, IGeometryImpl geometry)
    {
        var path = (SkiaGeometry)geometry;
        if (IsFilled(brush, geometry))
        {
            _canvas.DrawPath(path.Filled, _paint);
        }

        if (pen is not null && IsStroked(pen, pen.Brush is ISolidColorBrush ? default : geometry.Bounds))
        {
            _canvas.DrawPath(path.Stroked, _paint);
        }
    }

    public void DrawEllipse(IBrush? brush, IPen? pen, Rect rect)
    {
        if (IsFilled(brush, rect))
        {
            _canvas.DrawOval(rect.ToSkia(), _paint);
        }

        if (IsStroked(pen, rect))
        {
            _canvas.DrawOval(rect.ToSkia(), _paint);
        }
    }

    public void DrawRegion(IBrush? brush, IPen? pen, IPlatformRenderInterfaceRegion region) => throw new NotSupportedException();

    public void DrawRectangle(IBrush? brush, IPen? pen, RoundedRect rect, BoxShadows boxShadows = default)
    {
        foreach (var shadow in boxShadows)
        {
            Shadow(shadow, rect, isInset: false);
        }

        if (IsFilled(brush, rect.Rect))
        {
            Rectangle(rect);
        }

        foreach (var shadow in boxShadows)
        {
            Shadow(shadow, rect, isInset: true);
        }

        if (IsStroked(pen, rect.Rect))
        {
            Rectangle(rect);
        }
    }

    public void DrawGlyphRun(IBrush? foreground, IGlyphRunImpl glyphRun)
    {
        if (IsFilled(foreground, glyphRun.Bounds))
        {
            ((SkiaGlyphRun)glyphRun).Draw(_canvas, _paint);
        }
    }

    public void DrawBitmap(IBitmapImpl source, double opacity, Rect sourceRect, Rect destRect)
    {
        if (sourceRect.Width <= 0 || sourceRect.Height <= 0 || destRect.Width <= 0 || destRect.Height <= 0 || opacity <= 0)
        {
            return;
        }

        Touch();
        _paint.Reset();
        _paint.Color = Colors.Black.ToSkia(opacity);
        _paint.IsAntialias = IsSmooth;
        _canvas.DrawImage(((SkiaBitmap)source).Image, sourceRect.ToSkia(), destRect.ToSkia(), Sampling(sourceRect, destRect), _paint);
    }

    public void DrawBitmap(IBitmapImpl source, IBrush opacityMask, Rect opacityMaskRect, Rect destRect)
    {
        PushOpacityMask(opacityMask, opacityMaskRect);
        DrawBitmap(source, 1, new Rect(source.PixelSize.ToSize(1)), destRect);
        PopOpacityMask();
    }

    public IDrawingContextLayerImpl CreateLayer(PixelSize size) => new SkiaBitmap(size, new Vector(96, 96));

    public void PushClip(Rect clip)
    {
        Save();
        _canvas.ClipRect(clip.ToSkia(), SKClipOperation.Intersect, antialias: IsSmooth);
        ClippedAtFirst();
    }

    public void PushClip(RoundedRect clip)
    {
        Save();
        _canvas.ClipRoundRect(_rounded.Set(clip), SKClipOperation.Intersect, antialias: IsSmooth);
        ClippedAtFirst();
    }

    public void PushClip(IPlatformRenderInterfaceRegion region) => throw new NotSupportedException();

    public void PopClip() => Pop();

    public void PushGeometryClip(IGeometryImpl clip)
    {
        Save();
        _canvas.ClipPath(((SkiaGeometry)clip).Filled, SKClipOperation.Intersect, antialias: IsSmooth);
        ClippedAtFirst();
    }

    public void PopGeometryClip() => Pop();

    public void PushLayer(Rect bounds) => Layer(1, null);

    public void PopLayer() => Pop();

    public void PushOpacity(double opacity, Rect? bounds)
    {
        if (opacity >= 1)
        {
            _levels.Push(new(_transform, IsSaved: false));
        }
        else
        {
            Layer(opacity, bounds);
        }
    }

    public void PopOpacity() => Pop();

    public void PushOpacityMask(IBrush mask, Rect bounds)
    {
        Layer(1, null);
        _levels.Push(_levels.Pop() with { Mask = mask, Bounds = bounds });
    }

    public void PopOpacityMask()
    {
        // The mask keeps of the layer what it covers itself.
        var level = _levels.Peek();
        Transform = level.Transform;
        _paint.Reset();
        _paint.BlendMode = SKBlendMode.DstIn;
        if (!BrushPaint.Set(_paint, level.Mask, level.Bounds))
        {
            _paint.Color = SKColors.Transparent;
        }

        _canvas.DrawPaint(_paint);
        Pop();
    }

    public void PushRenderOptions(RenderOptions renderOptions) => _options.Push(renderOptions);

    public void PopRenderOptions() => _options.Pop();

    public void PushTextOptions(TextOptions textOptions)
    {
        // Text is drawn in one way only.
    }

    public void PopTextOptions()
    {
        // See above.
    }

    public object? GetFeature(Type t) => null;

    private void Touch()
    {
        if (_levels.Count == 0)
        {
            Damage?.All();
        }
    }

    private void ClippedAtFirst()
    {
        if (_levels.Count == 1)
        {
            Damage?.Add(_canvas.DeviceClipBounds);
        }
    }

    private void Save()
    {
        _levels.Push(new(_transform, IsSaved: true));
        _canvas.Save();
    }

    private void Layer(double opacity, Rect? bounds)
    {
        Touch();
        _levels.Push(new(_transform, IsSaved: true));
        _paint.Reset();
        _paint.Color = Colors.Black.ToSkia(opacity);
        if (bounds is { } limit)
        {
            _canvas.SaveLayer(limit.ToSkia(), _paint);
        }
        else
        {
            _canvas.SaveLayer(_paint);
        }
    }

    private void Pop()
    {
        var level = _levels.Pop();
        if (level.IsSaved)
        {
            _canvas.Restore();
            _transform = level.Transform;
        }
    }

    private void Rectangle(RoundedRect rect)
    {
        if (rect.IsRounded)
        {
            _canvas.DrawRoundRect(_rounded.Set(rect), _paint);
        }
        else
        {
            _canvas.DrawRect(rect.Rect.ToSkia(), _paint);
        }
    }

    private void Shadow(BoxShadow shadow, RoundedRect rect, bool isInset)
    {
        if (shadow.IsInset == isInset && shadow.Color.A > 0)
        {
            Touch();
            _paint.Reset();
            _paint.IsAntialias = true;
            BoxShadowDrawing.Draw(_canvas, _paint, shadow, rect);
        }
    }

    // Bounds of a path are computed only for brushes that depend on them.
    private bool IsFilled(IBrush? brush, IGeometryImpl geometry) =>
        brush is not null && IsFilled(brush, brush is ISolidColorBrush ? default : geometry.Bounds);

    private bool IsFilled(IBrush? brush, Rect target)
    {
        if (brush is null)
        {
            return false;
        }

        Touch();
        _paint.Reset();
        _paint.IsAntialias = IsSmooth;
        return BrushPaint.Set(_paint, brush, target);
    }

    private bool IsStroked(IPen? pen, Rect target)
    {
        if (pen is not { Thickness: > 0 } || !IsFilled(pen.Brush, target.Inflate(pen.Thickness / 2)))
        {
            return false;
        }

        PenPaint.Set(_paint, pen);
        return true;
    }

    private SKSamplingOptions Sampling(Rect source, Rect place)
    {
        var mode = _options.TryPeek(out var o) ? o.BitmapInterpolationMode : BitmapInterpolationMode.Unspecified;
        if (mode == BitmapInterpolationMode.None)
        {
            return new(SKFilterMode.Nearest);
        }

        // Pixels that become much smaller are averaged first.
        var matrix = _transform * _post;
        var isSmaller = place.Width * Math.Abs(matrix.M11) < source.Width / 2 || place.Height * Math.Abs(matrix.M22) < source.Height / 2;
        return mode == BitmapInterpolationMode.HighQuality && !isSmaller
            ? new(SKCubicResampler.Mitchell)
            : new(SKFilterMode.Linear, isSmaller ? SKMipmapMode.Linear : SKMipmapMode.None);
    }

    private readonly record struct Level(Matrix Transform, bool IsSaved, IBrush? Mask = null, Rect Bounds = default);
}
