using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

public sealed partial class X11PictureTests
{
    [Fact]
    public async Task A_screen_gets_the_rectangles_that_changed_and_no_others()
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(() =>
        {
            XServer.Connect();
            var (display, size) = (X11Connection.Display, new PixelSize(20, 10));
            var screen = Xlib.XDefaultScreen(display);
            var target = XCreatePixmap(display, Xlib.XRootWindow(display, screen), 20, 10, (uint)Xlib.XDefaultDepth(display, screen));
            using var frame = new SkiaBitmap(size, new Vector(96, 96));
            Fill(frame, Colors.Red);
            X11Picture.Put(target, screen, frame, [new PixelRect(size)]);
            Fill(frame, Colors.Blue);
            PixelRect[] changed = [new(2, 3, 5, 4), new(10, 0, 3, 3)];
            X11Picture.Put(target, screen, frame, changed);

            var seen = Pixels(target, size);
            for (var i = 0; i < seen.Length; i++)
            {
                var at = new PixelPoint(i % size.Width, i / size.Width);
                Assert.Equal(changed.Any(r => r.ContainsExclusive(at)) ? 0x0000FFu : 0xFF0000u, seen[i]);
            }
        });
    }

    private static void Fill(SkiaBitmap frame, Color color)
    {
        using var context = frame.CreateDrawingContext();
        context.Clear(color);
    }

    private static unsafe uint[] Pixels(nint drawable, PixelSize size)
    {
        var image = XGetImage(X11Connection.Display, drawable, 0, 0, (uint)size.Width, (uint)size.Height, uint.MaxValue, 2);
        var pixels = new uint[size.Width * size.Height];
        for (var i = 0; i < pixels.Length; i++)
        {
            var row = image->Data + (i / size.Width * image->BytesPerLine);
            pixels[i] = ((uint*)row)[i % size.Width] & 0xFFFFFF;
        }

        _ = Xlib.XFree((void*)image->Data);
        _ = Xlib.XFree(image);
        return pixels;
    }

    [LibraryImport(Xlib.Library)]
    private static partial nint XCreatePixmap(nint display, nint drawable, uint width, uint height, uint depth);

    [LibraryImport(Xlib.Library)]
    private static unsafe partial XImage* XGetImage(
        nint display, nint drawable, int x, int y, uint width, uint height, nuint planes, int format);
}
