using Avalonia;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Passes the pixels of frames to a window.</summary>
internal static unsafe class X11Picture
{
    // The format in which all bits of a pixel are together.
    private const int Together = 2;
    private const int Bits = 32;
    private const nuint Red = 0xFF0000, Green = 0xFF00, Blue = 0xFF;

    /// <summary>Ensures that a screen shows pixels as frames have them.</summary>
    /// <exception cref="PlatformNotSupportedException">It does not.</exception>
    public static void Demand(int screen)
    {
        if (Xlib.XDefaultDepth(X11Connection.Display, screen) is not (24 or 32))
        {
            throw Unsupported();
        }
    }

    /// <summary>Copies rectangles of a frame to the same places of a window.</summary>
    /// <exception cref="PlatformNotSupportedException">The screen does not have 8 bits each for red, green and blue.</exception>
    public static void Put(nint window, int screen, SkiaBitmap frame, IReadOnlyList<PixelRect> rects)
    {
        var display = X11Connection.Display;
        var image = Xlib.XCreateImage(
            display,
            Xlib.XDefaultVisual(display, screen),
            (uint)Xlib.XDefaultDepth(display, screen),
            Together,
            0,
            frame.Address,
            (uint)frame.PixelSize.Width,
            (uint)frame.PixelSize.Height,
            Bits,
            frame.RowBytes);
        try
        {
            if (image is null || image->BitsPerPixel != Bits || (image->RedMask, image->GreenMask, image->BlueMask) != (Red, Green, Blue))
            {
                throw Unsupported();
            }

            foreach (var rect in rects)
            {
                _ = Xlib.XPutImage(
                    display,
                    window,
                    Xlib.XDefaultGC(display, screen),
                    image,
                    rect.X,
                    rect.Y,
                    rect.X,
                    rect.Y,
                    (uint)rect.Width,
                    (uint)rect.Height);
            }
        }
        finally
        {
            // Only the description: the pixels are the frame's.
            _ = Xlib.XFree(image);
        }
    }

    private static PlatformNotSupportedException Unsupported() => new(
        "The X server's screen has other colors than 8 bits each for red, green and blue. The operator station needs a screen with a depth "
            + "of 24.");
}
