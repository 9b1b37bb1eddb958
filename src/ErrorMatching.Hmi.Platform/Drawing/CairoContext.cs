using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Avalonia's drawing operations over one cairo_t.</summary>
internal sealed unsafe class CairoContext : IDrawingContextImpl
{
    private enum Frame { Clip, Opacity, OpaqueOpacity, Mask, Layer }

    private readonly CairoBitmap _target;
    private readonly nint _cr;
    private readonly Matrix _post;
    private readonly Stack<(Frame Kind, Matrix Transform, double Opacity, IBrush? Mask, Rect Bounds)> _frames = new();
    private readonly Stack<RenderOptions> _options = new();
    private Matrix _transform = Matrix.Identity;

    public Action? Finished { get; init; }

    public CairoContext(CairoBitmap target, double scale)
    {
        _target = target;
        _cr = LibCairo.cairo_create(target.Surface);
        _post = Matrix.CreateScale(scale, scale);
        Transform = Matrix.Identity;
    }

    public Matrix Transform
    {
        get => _transform;
        set
        {
            _transform = value;
            var m = value * _post;
            // Cairo refuses a singular matrix, e.g. a zero scale, and then ignores everything after it.
            if (!m.HasInverse) m = Matrix.CreateScale(1e-6, 1e-6) * Matrix.CreateTranslation(m.M31, m.M32);
            LibCairo.cairo_set_matrix(_cr, BrushPattern.ToCairo(m));
        }
    }

    public void Dispose()
    {
        var status = LibCairo.cairo_status(_cr);
        LibCairo.cairo_destroy(_cr);
        LibCairo.cairo_surface_flush(_target.Surface);
        if (status != 0) throw new InvalidOperationException($"cairo status {status} while drawing");
        Finished?.Invoke();
    }

    private bool SetSource(IBrush? brush, Rect target)
    {
        var pattern = BrushPattern.Of(brush, target);
        if (pattern == 0) return false;
        LibCairo.cairo_set_source(_cr, pattern);
        LibCairo.cairo_pattern_destroy(pattern);
        return true;
    }

    private void Draw(IBrush? brush, IPen? pen, CairoGeometry geometry, Rect target)
    {
        if (SetSource(brush, target))
        {
            LibCairo.cairo_new_path(_cr);
            geometry.AddTo(_cr);
            LibCairo.cairo_fill(_cr);
        }
        if (pen is { Thickness: > 0 } && SetSource(pen.Brush, target.Inflate(pen.Thickness / 2)))
        {
            LibCairo.cairo_new_path(_cr);
            geometry.AddTo(_cr);
            CairoGeometry.ApplyPen(_cr, pen);
            LibCairo.cairo_stroke(_cr);
        }
    }

    // ---- drawing
    public void Clear(Color color)
    {
        LibCairo.cairo_save(_cr);
        LibCairo.cairo_set_operator(_cr, LibCairo.OperatorSource);
        LibCairo.cairo_set_source_rgba(
            _cr, BrushPattern.Unit(color.R), BrushPattern.Unit(color.G), BrushPattern.Unit(color.B), BrushPattern.Unit(color.A));
        LibCairo.cairo_paint(_cr);
        LibCairo.cairo_restore(_cr);
    }

    public void DrawLine(IPen? pen, Point p1, Point p2)
    {
        if (pen is not null) Draw(null, pen, new CairoGeometry().Move(p1).Line(p2), new Rect(p1, p2).Normalize());
    }

    public void DrawGeometry(IBrush? brush, IPen? pen, IGeometryImpl geometry) =>
        Draw(brush, pen, (CairoGeometry)geometry, geometry.Bounds);
    public void DrawEllipse(IBrush? brush, IPen? pen, Rect rect) => Draw(brush, pen, CairoGeometry.Ellipse(rect), rect);
    public void DrawRegion(IBrush? brush, IPen? pen, IPlatformRenderInterfaceRegion region) => throw new NotSupportedException();

    public void DrawRectangle(IBrush? brush, IPen? pen, RoundedRect rect, BoxShadows boxShadows = default)
    {
        foreach (var shadow in boxShadows)
            if (shadow is { IsInset: false } && shadow.Color.A > 0) BoxShadowDrawing.Draw(_cr, shadow, rect);
        Draw(brush, pen, rect.IsRounded ? CairoGeometry.Rounded(rect) : CairoGeometry.Rectangle(rect.Rect), rect.Rect);
    }

    public void DrawGlyphRun(IBrush? foreground, IGlyphRunImpl glyphRun)
    {
        if (!SetSource(foreground, glyphRun.Bounds)) return;
        LibCairo.cairo_new_path(_cr);
        LibCairo.cairo_set_fill_rule(_cr, LibCairo.FillWinding);
        ((CairoGlyphRun)glyphRun).AddTo(_cr);
        LibCairo.cairo_fill(_cr);
    }

    public void DrawBitmap(IBitmapImpl source, double opacity, Rect sourceRect, Rect destRect)
    {
        if (sourceRect.Width <= 0 || sourceRect.Height <= 0 || destRect.Width <= 0 || destRect.Height <= 0) return;
        LibCairo.cairo_save(_cr);
        LibCairo.cairo_new_path(_cr);
        LibCairo.cairo_rectangle(_cr, destRect.X, destRect.Y, destRect.Width, destRect.Height);
        LibCairo.cairo_clip(_cr);
        var pattern = LibCairo.cairo_pattern_create_for_surface(((CairoBitmap)source).Surface);
        double sx = sourceRect.Width / destRect.Width, sy = sourceRect.Height / destRect.Height;
        LibCairo.cairo_pattern_set_matrix(
            pattern, new LibCairo.Mat { Xx = sx, Yy = sy, X0 = sourceRect.X - destRect.X * sx, Y0 = sourceRect.Y - destRect.Y * sy });
        LibCairo.cairo_pattern_set_extend(pattern, LibCairo.ExtendPad);
        var mode = _options.TryPeek(out var o) ? o.BitmapInterpolationMode : BitmapInterpolationMode.Unspecified;
        LibCairo.cairo_pattern_set_filter(pattern, mode == BitmapInterpolationMode.None ? LibCairo.FilterNearest : LibCairo.FilterGood);
        LibCairo.cairo_set_source(_cr, pattern);
        LibCairo.cairo_pattern_destroy(pattern);
        LibCairo.cairo_paint_with_alpha(_cr, opacity);
        LibCairo.cairo_restore(_cr);
    }

    public void DrawBitmap(IBitmapImpl source, IBrush opacityMask, Rect opacityMaskRect, Rect destRect)
    {
        PushOpacityMask(opacityMask, opacityMaskRect);
        DrawBitmap(source, 1, new Rect(source.PixelSize.ToSize(1)), destRect);
        PopOpacityMask();
    }

    public IDrawingContextLayerImpl CreateLayer(PixelSize size) => new CairoBitmap(size, new Vector(96, 96));

    // ---- state
    private void Push(Frame kind, double opacity = 1, IBrush? mask = null, Rect bounds = default)
    {
        _frames.Push((kind, _transform, opacity, mask, bounds));
        if (kind == Frame.OpaqueOpacity) return;
        LibCairo.cairo_save(_cr);
        if (kind != Frame.Clip) LibCairo.cairo_push_group(_cr);
    }

    private void Pop()
    {
        var frame = _frames.Pop();
        if (frame.Kind == Frame.OpaqueOpacity) return;
        if (frame.Kind != Frame.Clip)
        {
            LibCairo.cairo_pop_group_to_source(_cr); // also restores the matrix of the push
            if (frame.Kind == Frame.Mask)
            {
                var mask = BrushPattern.Of(frame.Mask, frame.Bounds);
                if (mask != 0)
                {
                    LibCairo.cairo_mask(_cr, mask);
                    LibCairo.cairo_pattern_destroy(mask);
                }
            }
            else LibCairo.cairo_paint_with_alpha(_cr, frame.Opacity);
        }
        LibCairo.cairo_restore(_cr);
        Transform = frame.Transform;
    }

    private void Clip(CairoGeometry geometry)
    {
        Push(Frame.Clip);
        LibCairo.cairo_new_path(_cr);
        geometry.AddTo(_cr);
        LibCairo.cairo_clip(_cr);
    }

    public void PushClip(Rect clip) => Clip(CairoGeometry.Rectangle(clip));
    public void PushClip(RoundedRect clip) => Clip(CairoGeometry.Rounded(clip));
    public void PushClip(IPlatformRenderInterfaceRegion region) => throw new NotSupportedException();
    public void PopClip() => Pop();
    public void PushGeometryClip(IGeometryImpl clip) => Clip((CairoGeometry)clip);
    public void PopGeometryClip() => Pop();
    public void PushLayer(Rect bounds) => Push(Frame.Layer);
    public void PopLayer() => Pop();
    public void PushOpacity(double opacity, Rect? bounds) => Push(opacity >= 1 ? Frame.OpaqueOpacity : Frame.Opacity, opacity);
    public void PopOpacity() => Pop();
    public void PushOpacityMask(IBrush mask, Rect bounds) => Push(Frame.Mask, 1, mask, bounds);
    public void PopOpacityMask() => Pop();

    public void PushRenderOptions(RenderOptions renderOptions)
    {
        _options.Push(renderOptions);
        LibCairo.cairo_set_antialias(_cr, renderOptions.EdgeMode == EdgeMode.Aliased ? LibCairo.AntialiasNone : LibCairo.AntialiasDefault);
    }

    public void PopRenderOptions()
    {
        _options.Pop();
        LibCairo.cairo_set_antialias(
            _cr, _options.TryPeek(out var o) && o.EdgeMode == EdgeMode.Aliased ? LibCairo.AntialiasNone : LibCairo.AntialiasDefault);
    }

    public void PushTextOptions(TextOptions textOptions) { }
    public void PopTextOptions() { }
    public object? GetFeature(Type t) => null;
}
