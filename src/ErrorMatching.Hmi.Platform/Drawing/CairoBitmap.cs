using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A premultiplied BGRA image surface: bitmap, layer, render-target bitmap and window frame in one.</summary>
internal sealed unsafe class CairoBitmap : IWriteableBitmapImpl, IRenderTargetBitmapImpl, IDrawingContextLayerImpl
{
    private readonly double _drawScale;

    public CairoBitmap(PixelSize size, Vector dpi, double drawScale = 1)
        : this(LibCairo.cairo_image_surface_create(LibCairo.FormatArgb32, Math.Max(1, size.Width), Math.Max(1, size.Height)), dpi) =>
            _drawScale = drawScale;

    private CairoBitmap(nint surface, Vector dpi)
    {
        if (LibCairo.cairo_surface_status(surface) is var status and not 0)
            throw new InvalidDataException($"cairo surface status {status} (only PNG images are supported)");
        Surface = surface;
        Dpi = dpi;
        PixelSize = new PixelSize(LibCairo.cairo_image_surface_get_width(surface), LibCairo.cairo_image_surface_get_height(surface));
        _drawScale = 1;
    }

    public nint Surface { get; private set; }
    public Vector Dpi { get; }
    public PixelSize PixelSize { get; }
    public int Version { get; private set; } = 1;
    public PixelFormat? Format => PixelFormat.Bgra8888;
    public AlphaFormat? AlphaFormat => Avalonia.Platform.AlphaFormat.Premul;
    public bool CanBlit => false;
    public bool IsCorrupted => false;
    public void Blit(IDrawingContextImpl context) => throw new NotSupportedException();
    public IDrawingContextImpl CreateDrawingContext() { Version++; return new CairoContext(this, _drawScale); }

    public ILockedFramebuffer Lock()
    {
        LibCairo.cairo_surface_flush(Surface);
        return new LockedFramebuffer(
            (nint)LibCairo.cairo_image_surface_get_data(Surface),
            PixelSize,
            LibCairo.cairo_image_surface_get_stride(Surface),
            Dpi,
            PixelFormat.Bgra8888, Avalonia.Platform.AlphaFormat.Premul, () => { LibCairo.cairo_surface_mark_dirty(Surface); Version++; });
    }

    public static CairoBitmap FromPixels(AlphaFormat alpha, nint data, PixelSize size, Vector dpi, int stride)
    {
        var bitmap = new CairoBitmap(size, dpi);
        using var to = bitmap.Lock();
        for (var y = 0; y < size.Height; y++)
        {
            var row = new Span<byte>((void*)(to.Address + y * to.RowBytes), size.Width * 4);
            new ReadOnlySpan<byte>((void*)(data + y * stride), size.Width * 4).CopyTo(row);
            for (var x = 0; x < row.Length; x += 4)
                if (alpha == Avalonia.Platform.AlphaFormat.Opaque) row[x + 3] = 255;
                else if (alpha == Avalonia.Platform.AlphaFormat.Unpremul)
                    for (var c = 0; c < 3; c++) row[x + c] = (byte)(row[x + c] * row[x + 3] / 255);
        }
        return bitmap;
    }

    public static CairoBitmap FromPng(Stream stream)
    {
        using var transfer = new PngTransfer(stream);
        var surface = LibCairo.cairo_image_surface_create_from_png_stream(&Read, transfer.Closure);
        if (transfer.Failure is { } failure)
        {
            LibCairo.cairo_surface_destroy(surface);
            throw new IOException($"The picture could not be read: {failure.Message}", failure);
        }

        return new CairoBitmap(surface, new Vector(96, 96));
    }

    public void Save(Stream stream, BitmapEncoderOptions options)
    {
        using var transfer = new PngTransfer(stream);
        var status = LibCairo.cairo_surface_write_to_png_stream(Surface, &Write, transfer.Closure);
        if (transfer.Failure is { } failure)
        {
            throw new IOException($"The picture could not be written: {failure.Message}", failure);
        }

        if (status != 0)
        {
            throw new IOException($"The picture could not be written (cairo status {status}).");
        }
    }

    public CairoBitmap Scaled(PixelSize size)
    {
        var result = new CairoBitmap(size, Dpi);
        using var context = (CairoContext)result.CreateDrawingContext();
        context.DrawBitmap(this, 1, new Rect(PixelSize.ToSize(1)), new Rect(size.ToSize(1)));
        return result;
    }

    public void Dispose()
    {
        if (Surface != 0) LibCairo.cairo_surface_destroy(Surface);
        Surface = 0;
    }

    [UnmanagedCallersOnly(CallConvs = [typeof(System.Runtime.CompilerServices.CallConvCdecl)])]
    // CAIRO_STATUS_READ_ERROR
    private static int Read(nint closure, byte* data, uint length) =>
        PngTransfer.Of(closure).Read(new Span<byte>(data, (int)length)) ? 0 : 10;

    [UnmanagedCallersOnly(CallConvs = [typeof(System.Runtime.CompilerServices.CallConvCdecl)])]
    // CAIRO_STATUS_WRITE_ERROR
    private static int Write(nint closure, byte* data, uint length) =>
        PngTransfer.Of(closure).Write(new ReadOnlySpan<byte>(data, (int)length)) ? 0 : 11;
}
