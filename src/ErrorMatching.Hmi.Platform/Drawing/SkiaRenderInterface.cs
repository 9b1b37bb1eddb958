using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

internal sealed class SkiaRenderInterface : IPlatformRenderInterface
{
    private sealed class Backend : IPlatformRenderInterfaceContext
    {
        public bool IsLost => false;
        public IReadOnlyDictionary<Type, object> PublicFeatures { get; } = new Dictionary<Type, object>();
        public PixelSize? MaxOffscreenRenderTargetPixelSize => null;
        public IRenderTarget CreateRenderTarget(IEnumerable<IPlatformRenderSurface> surfaces) =>
            new FrameRenderTarget(surfaces.OfType<FrameSurface>().First());
        public IDrawingContextLayerImpl CreateOffscreenRenderTarget(PixelSize pixelSize, Vector scaling, bool enableTextAntialiasing)
            => new SkiaBitmap(pixelSize, new Vector(96, 96) * scaling.X, scaling.X);
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

    public IGeometryImpl CreateEllipseGeometry(Rect rect) => SkiaGeometry.Of(b => b.AddOval(rect.ToSkia(), SKPathDirection.Clockwise));
    public IGeometryImpl CreateLineGeometry(Point p1, Point p2) => SkiaGeometry.Line(p1, p2);
    public IGeometryImpl CreateRectangleGeometry(Rect rect) => SkiaGeometry.Of(b => b.AddRect(rect.ToSkia(), SKPathDirection.Clockwise));
    public IStreamGeometryImpl CreateStreamGeometry() => new SkiaStreamGeometry();
    public IGeometryImpl CreateGeometryGroup(FillRule fillRule, IReadOnlyList<IGeometryImpl> children) =>
        SkiaGeometry.Group(fillRule, children);

    public IGeometryImpl CreateCombinedGeometry(GeometryCombineMode combineMode, IGeometryImpl g1, IGeometryImpl g2) =>
        SkiaGeometry.Combined(combineMode, g1, g2);

    public IGeometryImpl BuildGlyphRunGeometry(GlyphRun glyphRun)
    {
        using var run = new SkiaGlyphRun(
            glyphRun.GlyphTypeface, glyphRun.FontRenderingEmSize, glyphRun.GlyphInfos, glyphRun.BaselineOrigin);
        return new SkiaGeometry(run.Outlines());
    }

    public IGlyphRunImpl CreateGlyphRun(
        GlyphTypeface glyphTypeface, double fontRenderingEmSize, IReadOnlyList<GlyphInfo> glyphInfos, Point baselineOrigin)
        => new SkiaGlyphRun(glyphTypeface, fontRenderingEmSize, glyphInfos, baselineOrigin);

    public IRenderTargetBitmapImpl CreateRenderTargetBitmap(PixelSize size, Vector dpi) => new SkiaBitmap(size, dpi, dpi.X / 96);
    public IWriteableBitmapImpl CreateWriteableBitmap(PixelSize size, Vector dpi, PixelFormat format, AlphaFormat alphaFormat) =>
        new SkiaBitmap(size, dpi, 1, alphaFormat);

    public IBitmapImpl LoadBitmap(string fileName) => LoadWriteableBitmap(fileName);
    public IBitmapImpl LoadBitmap(Stream stream) => SkiaBitmap.Decode(stream);
    public IBitmapImpl LoadBitmap(PixelFormat format, AlphaFormat alphaFormat, nint data, PixelSize size, Vector dpi, int stride)
        => SkiaBitmap.FromPixels(alphaFormat, data, size, dpi, stride);
    public IBitmapImpl LoadBitmapToWidth(Stream stream, int width, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        LoadWriteableBitmapToWidth(stream, width, mode);
    public IBitmapImpl LoadBitmapToHeight(Stream stream, int height, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        LoadWriteableBitmapToHeight(stream, height, mode);
    public IBitmapImpl ResizeBitmap(
        IBitmapImpl bitmapImpl, PixelSize size, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality) =>
        ((SkiaBitmap)bitmapImpl).Scaled(size);
    public IWriteableBitmapImpl LoadWriteableBitmap(Stream stream) => SkiaBitmap.Decode(stream);

    public IWriteableBitmapImpl LoadWriteableBitmap(string fileName)
    {
        using var file = File.OpenRead(fileName);
        return SkiaBitmap.Decode(file);
    }

    public IWriteableBitmapImpl LoadWriteableBitmapToWidth(
        Stream stream, int width, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality)
    {
        using var full = SkiaBitmap.Decode(stream);
        return full.Scaled(new PixelSize(width, Math.Max(1, full.PixelSize.Height * width / full.PixelSize.Width)));
    }

    public IWriteableBitmapImpl LoadWriteableBitmapToHeight(
        Stream stream, int height, BitmapInterpolationMode mode = BitmapInterpolationMode.HighQuality)
    {
        using var full = SkiaBitmap.Decode(stream);
        return full.Scaled(new PixelSize(Math.Max(1, full.PixelSize.Width * height / full.PixelSize.Height), height));
    }
}
