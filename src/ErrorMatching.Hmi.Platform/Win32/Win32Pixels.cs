using Avalonia;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Memory for a frame that Skia draws into. The system copies what has changed to a window.</summary>
internal sealed unsafe class Win32Pixels : IDisposable
{
    private readonly nint _dc, _bitmap, _before;

    /// <summary>Allocates it, all zero.</summary>
    /// <exception cref="PlatformNotSupportedException">There is no memory.</exception>
    public Win32Pixels(PixelSize size)
    {
        // A negative height: the first row is the top one.
        var header = new Gdi32.BitmapHeader
        {
            Bytes = sizeof(Gdi32.BitmapHeader),
            Width = size.Width,
            Height = -size.Height,
            Planes = 1,
            Bits = 32,
        };
        nint bits;
        _dc = Gdi32.CreateCompatibleDC(0);
        _bitmap = Gdi32.CreateDIBSection(_dc, &header, 0, &bits, 0, 0);
        if (_bitmap == 0)
        {
            _ = Gdi32.DeleteDC(_dc);
            throw new PlatformNotSupportedException("Windows has no memory for the pictures of the operator station.");
        }

        _before = Gdi32.SelectObject(_dc, _bitmap);
        (Address, Size) = (bits, size);
    }

    /// <summary>The address of the first pixel. Rows follow each other without gaps.</summary>
    public nint Address { get; }

    /// <summary>Width and height.</summary>
    public PixelSize Size { get; }

    /// <summary>Waits until the system has read what it was asked to; call it before the pixels change.</summary>
    public static void Wait() => _ = Gdi32.GdiFlush();

    /// <summary>Copies a rectangle to the same place of a window.</summary>
    public void Put(nint to, PixelRect rect) =>
        _ = Gdi32.BitBlt(to, rect.X, rect.Y, rect.Width, rect.Height, _dc, rect.X, rect.Y, Gdi32.Copy);

    public void Dispose()
    {
        _ = Gdi32.SelectObject(_dc, _before);
        _ = Gdi32.DeleteObject(_bitmap);
        _ = Gdi32.DeleteDC(_dc);
    }
}
