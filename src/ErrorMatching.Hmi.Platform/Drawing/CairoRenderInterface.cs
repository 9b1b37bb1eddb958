using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;

namespace ErrorMatching.Hmi.Platform;

internal sealed class CairoRenderInterface : IPlatformRenderInterface
{
    private sealed class Backend : IPlatformRenderInterfaceContext
    {
        public bool IsLost => false;
        public IReadOnlyDictionary<Type, object> PublicFeatures { get; } = new Dictionary<Type, object>();
        public PixelSize? MaxOffscreenRenderTargetPixelSize => null;
        public IRenderTarget CreateRenderTarget(IEnumerable<IPlatformRenderSurface> surfaces) =>
            new FrameRenderTarget(surfaces.OfType<FrameSurface>().First());
        public IDrawingContextLayerImpl CreateOffscreenRenderTarget(PixelSize pixelSize, Vector scaling, bool enableTextAntialiasing)
            => new CairoBitmap(pixelSize, new Vector(96, 96) * scaling.X, scaling.X);
        public object? TryGetFeature(Type featureType) => null;
        public void Dispose() { }
    }

    public bool SupportsIndividualRoundRects => true;
    public AlphaFormat DefaultAlphaFormat => AlphaFormat.Premul;
    public PixelFormat DefaultPixelFormat => PixelFormat.Bgra8888;
    public bool SupportsRegions => false;
    public bool IsSupportedBitmapPixelFormat(PixelFormat format) => format == PixelFormat.Bgra8888;
    public IPlatformRenderInterfaceRegion CreateRegion() => throw new NotSupportedException();
    public IPlatformRenderInterfaceContext CreateBackendContext(IPlatformGraphicsContext? graphicsApiContext) => new Backend();

    public IGeometryImpl CreateEllipseGeometry(Rect rect) => CairoGeometry.Ellipse(rect);
    public IGeometryImpl CreateLineGeometry(Point p1, Point p2) => new CairoGeometry().Move(p1).Line(p2);
    public IGeometryImpl CreateRectangleGeometry(Rect rect) => CairoGeometry.Rectangle(rect);
    public IStreamGeometryImpl CreateStreamGeometry() => new CairoGeometry.Stream();
    public IGeometryImpl CreateGeometryGroup(FillRule fillRule, IReadOnlyList<IGeometryImpl> children) =>
        CairoGeometry.Group(fillRule, children);

    /// <summary>Cairo has no path booleans. Union and Xor are exact as fills; Exclude is exact if the second geometry is inside the
    /// first.</summary>
    public IGeometryImpl CreateCombinedGeometry(GeometryCombineMode combineMode, IGeometryImpl g1, IGeometryImpl g2) => combineMode switch
    {
        GeometryCombineMode.Union => CairoGeometry.Group(FillRule.NonZero, [g1, g2]),
        GeometryCombineMode.Intersect => g1.Intersect(g2)!,
        _ => CairoGeometry.Group(FillRule.EvenOdd, [g1, g2]),
    };

    public IGeometryImpl BuildGlyphRunGeometry(GlyphRun glyphRun)
    {
        var cr = CairoGeometry.Scratch;
        new CairoGlyphRun(glyphRun.GlyphTypeface, glyphRun.FontRenderingEmSize, glyphRun.GlyphInfos, glyphRun.BaselineOrigin).AddTo(cr);
        return CairoGeometry.FromPath(cr);
    }

    public IGlyphRunImpl CreateGlyphRun(
        GlyphTypeface glyphTypeface, double fontRenderingEmSize, IReadOnlyList<GlyphInfo> glyphInfos, Point baselineOrigin)
        => new CairoGlyphRun(glyphTypeface, fontRenderingEmSize, glyphInfos, baselineOrigin);

    public IRenderTargetBitmapImpl CreateRenderTargetBitmap(PixelSize size, Vector dpi) => new CairoBitmap(size, dpi, dpi.X / 96);
    public IWriteableBitmapImpl CreateWriteableBitmap(PixelSize size, Vector dpi, PixelFormat format, AlphaFormat alphaFormat) =>
        new CairoBitmap(size, dpi);

    public IBitmapImpl LoadBitmap(string fileName) => LoadWriteableBitmap(fileName);
    public IBitmapImpl LoadBitmap(Stream stream) => CairoBitmap.FromPng(stream);
    public IBitmapImpl LoadBitmap(PixelFormat format, AlphaFormat alphaFormat, nint data, PixelSize size, Vector dpi, int stride)
        => CairoBitmap.FromPixels(alphaFormat, data, size, dpi, stride);
    public IBitmapImpl LoadBitmapToWidth(Stream stream, int width, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        LoadWriteableBitmapToWidth(stream, width, mode);
    public IBitmapImpl LoadBitmapToHeight(Stream stream, int height, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        LoadWriteableBitmapToHeight(stream, height, mode);
    public IBitmapImpl ResizeBitmap(
        IBitmapImpl bitmapImpl, PixelSize size, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        ((CairoBitmap)bitmapImpl).Scaled(size);
    public IWriteableBitmapImpl LoadWriteableBitmap(Stream stream) => CairoBitmap.FromPng(stream);

    public IWriteableBitmapImpl LoadWriteableBitmap(string fileName)
    {
        using var file = File.OpenRead(fileName);
        return CairoBitmap.FromPng(file);
    }

    public IWriteableBitmapImpl LoadWriteableBitmapToWidth(
        Stream stream, int width, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality)
    {
        using var full = CairoBitmap.FromPng(stream);
        return full.Scaled(new PixelSize(width, Math.Max(1, full.PixelSize.Height * width / full.PixelSize.Width)));
    }

    public IWriteableBitmapImpl LoadWriteableBitmapToHeight(
        Stream stream, int height, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality)
    {
        using var full = CairoBitmap.FromPng(stream);
        return full.Scaled(new PixelSize(Math.Max(1, full.PixelSize.Width * height / full.PixelSize.Height), height));
    }
}
