using System.IO.Compression;
using Avalonia;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Pixels in memory (BGRA): bitmap, layer, render-target bitmap and window frame in one.</summary>
internal sealed class SkiaBitmap : IWriteableBitmapImpl, IRenderTargetBitmapImpl, IDrawingContextLayerImpl
{
    private const int MostEncoded = 64 << 20;
    private const long MostPixels = 64 << 20;
    private readonly double _drawScale;
    private readonly SKBitmap _pixels;
    private readonly Action? _release;
    private SKImage? _image;

    /// <summary>Creates a transparent bitmap.</summary>
    public SkiaBitmap(PixelSize size, Vector dpi, double drawScale = 1, AlphaFormat alpha = Avalonia.Platform.AlphaFormat.Premul)
        : this(new SKBitmap(Describe(size, alpha), SKBitmapAllocFlags.ZeroPixels), dpi, drawScale, alpha)
    {
    }

    /// <summary>Creates a bitmap in memory that is already there, with its rows one after the other.</summary>
    /// <param name="size">Its size, at least one by one.</param>
    /// <param name="dpi">Its resolution.</param>
    /// <param name="memory">The address of the first pixel.</param>
    /// <param name="release">Called when the bitmap no longer needs the memory.</param>
    public SkiaBitmap(PixelSize size, Vector dpi, nint memory, Action release)
        : this(new SKBitmap(), dpi, 1, Avalonia.Platform.AlphaFormat.Premul)
    {
        var description = Describe(size, Avalonia.Platform.AlphaFormat.Premul);
        _ = _pixels.InstallPixels(description, memory, description.RowBytes);
        (PixelSize, _release) = (size, release);
    }

    private SkiaBitmap(SKBitmap pixels, Vector dpi, double drawScale, AlphaFormat alpha)
    {
        (_pixels, Dpi, _drawScale, AlphaFormat) = (pixels, dpi, drawScale, alpha);
        PixelSize = new PixelSize(_pixels.Width, _pixels.Height);
    }

    public Vector Dpi { get; }

    public PixelSize PixelSize { get; }

    public int Version { get; private set; } = 1;

    public PixelFormat? Format => PixelFormat.Bgra8888;

    public AlphaFormat? AlphaFormat { get; }

    public bool CanBlit => false;

    public bool IsCorrupted => false;

    /// <summary>The address of the first pixel.</summary>
    public nint Address => _pixels.GetPixels();

    /// <summary>Bytes from one row to the next.</summary>
    public int RowBytes => _pixels.RowBytes;

    /// <summary>The pixels as a picture to draw from: without a copy, and the same object until they change.</summary>
    public SKImage Image
    {
        get
        {
            if (_image is null)
            {
                using var pixels = _pixels.PeekPixels();
                _image = SKImage.FromPixels(pixels);
            }

            return _image;
        }
    }

    /// <summary>Copies pixels.</summary>
    public static unsafe SkiaBitmap FromPixels(AlphaFormat alpha, nint data, PixelSize size, Vector dpi, int stride)
    {
        var bitmap = new SkiaBitmap(size, dpi, 1, alpha);
        for (var y = 0; y < size.Height; y++)
        {
            new ReadOnlySpan<byte>((void*)(data + (y * stride)), size.Width * 4)
                .CopyTo(new Span<byte>((void*)(bitmap.Address + (y * bitmap.RowBytes)), size.Width * 4));
        }

        return bitmap;
    }

    /// <summary>Reads a picture file (PNG, JPEG, WebP).</summary>
    /// <exception cref="IOException">The stream fails, ends too early, or is no picture.</exception>
    public static SkiaBitmap Decode(Stream stream)
    {
        // Exceptions of a stream must not pass through native code: its bytes are read first.
        using var bytes = new MemoryStream();
        try
        {
            var piece = new byte[1 << 14];
            for (int read; (read = stream.Read(piece)) > 0 && bytes.Length <= MostEncoded;)
            {
                bytes.Write(piece, 0, read);
            }
        }
        catch (Exception e)
        {
            throw new IOException($"The picture could not be read: {e.Message}", e);
        }

        using var data = SKData.CreateCopy(bytes.GetBuffer().AsSpan(0, (int)bytes.Length));
        using var codec = SKCodec.Create(data);
        if (codec is null || bytes.Length > MostEncoded || (long)codec.Info.Width * codec.Info.Height > MostPixels)
        {
            throw new IOException("The picture could not be read: it is torn, too large, or no picture.", new EndOfStreamException());
        }

        var bitmap = new SkiaBitmap(new PixelSize(codec.Info.Width, codec.Info.Height), new Vector(96, 96));
        var result = codec.GetPixels(bitmap._pixels.Info, bitmap.Address);
        if (result != SKCodecResult.Success)
        {
            bitmap.Dispose();
            throw new IOException(
                $"The picture could not be read: {result}.", result == SKCodecResult.IncompleteInput ? new EndOfStreamException() : null);
        }

        return bitmap;
    }

    public void Blit(IDrawingContextImpl context) => throw new NotSupportedException();

    public IDrawingContextImpl CreateDrawingContext() => Draw(_drawScale, null, null);

    /// <summary>Begins to draw.</summary>
    /// <param name="scale">Pixels per unit.</param>
    /// <param name="damage">Records which pixels are drawn on; null if nobody wants to know.</param>
    /// <param name="finished">Called at the end; null for nothing.</param>
    public SkiaContext Draw(double scale, Damage? damage, Action? finished)
    {
        Change();
        return new SkiaContext(new SKCanvas(_pixels), scale) { Damage = damage, Finished = finished };
    }

    public ILockedFramebuffer Lock() =>
        new LockedFramebuffer(Address, PixelSize, RowBytes, Dpi, PixelFormat.Bgra8888, AlphaFormat!.Value, Change);

    /// <summary>Draws the picture into one of another size.</summary>
    public SkiaBitmap Scaled(PixelSize size)
    {
        var result = new SkiaBitmap(size, Dpi);
        using var context = (SkiaContext)result.CreateDrawingContext();
        context.DrawBitmap(this, 1, new Rect(PixelSize.ToSize(1)), new Rect(size.ToSize(1)));
        return result;
    }

    public void Save(Stream stream, BitmapEncoderOptions options)
    {
        var level = (options as PngBitmapEncoderOptions)?.CompressionLevel switch
        {
            CompressionLevel.NoCompression => 0,
            CompressionLevel.Fastest => 1,
            CompressionLevel.SmallestSize => 9,
            _ => 6,
        };
        using var pixels = _pixels.PeekPixels();
        using var encoded = pixels.Encode(new SKPngEncoderOptions(SKPngEncoderFilterFlags.AllFilters, level));
        if (encoded is null)
        {
            throw new IOException("The picture could not be written.");
        }

        try
        {
            stream.Write(encoded.AsSpan());
        }
        catch (Exception e)
        {
            throw new IOException($"The picture could not be written: {e.Message}", e);
        }
    }

    public void Dispose()
    {
        _image?.Dispose();
        _image = null;
        _pixels.Dispose();
        _release?.Invoke();
    }

    private static SKImageInfo Describe(PixelSize size, AlphaFormat alpha) => new(
        Math.Max(1, size.Width),
        Math.Max(1, size.Height),
        SKColorType.Bgra8888,
        alpha switch
        {
            Avalonia.Platform.AlphaFormat.Opaque => SKAlphaType.Opaque,
            Avalonia.Platform.AlphaFormat.Unpremul => SKAlphaType.Unpremul,
            _ => SKAlphaType.Premul,
        });

    // Skia keeps what it made of a picture, such as a smaller one, for as long as it is the same object.
    private void Change()
    {
        Version++;
        _image?.Dispose();
        _image = null;
    }
}
