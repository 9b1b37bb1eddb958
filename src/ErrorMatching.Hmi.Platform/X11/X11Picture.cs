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
    /// <param name="window">The window.</param>
    /// <param name="screen">Its screen.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="shared">The frame's memory, if the server reads it itself; null if the pixels go through the socket.</param>
    /// <param name="rects">The rectangles, in pixels.</param>
    /// <exception cref="PlatformNotSupportedException">The screen does not have 8 bits each for red, green and blue.</exception>
    public static void Put(nint window, int screen, SkiaBitmap frame, X11SharedPixels? shared, IReadOnlyList<PixelRect> rects)
    {
        var display = X11Connection.Display;
        var (visual, depth) = (Xlib.XDefaultVisual(display, screen), (uint)Xlib.XDefaultDepth(display, screen));
        var (width, height) = ((uint)frame.PixelSize.Width, (uint)frame.PixelSize.Height);
        var image = shared is null
            ? Xlib.XCreateImage(display, visual, depth, Together, 0, frame.Address, width, height, Bits, frame.RowBytes)
            : XShm.XShmCreateImage(display, visual, depth, Together, shared.Address, shared.Segment, width, height);
        try
        {
            if (image is null || image->BitsPerPixel != Bits || (image->RedMask, image->GreenMask, image->BlueMask) != (Red, Green, Blue))
            {
                throw Unsupported();
            }

            var gc = Xlib.XDefaultGC(display, screen);
            foreach (var rect in rects)
            {
                var (wide, high) = ((uint)rect.Width, (uint)rect.Height);
                _ = shared is null
                    ? Xlib.XPutImage(display, window, gc, image, rect.X, rect.Y, rect.X, rect.Y, wide, high)
                    : XShm.XShmPutImage(display, window, gc, image, rect.X, rect.Y, rect.X, rect.Y, wide, high, 0);
            }

            shared?.Reads();
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
