using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

public sealed partial class X11PictureTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_screen_gets_the_rectangles_that_changed_and_no_others(bool isShared)
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(() =>
        {
            XServer.Connect();
            var (display, size) = (X11Connection.Display, new PixelSize(20, 10));
            var screen = Xlib.XDefaultScreen(display);
            var target = XCreatePixmap(display, Xlib.XRootWindow(display, screen), 20, 10, (uint)Xlib.XDefaultDepth(display, screen));
            using var shared = isShared ? X11SharedPixels.Create(size) : null;
            Assert.Equal(isShared, shared is not null);
            using var frame = shared is null
                ? new SkiaBitmap(size, new Vector(96, 96))
                : new SkiaBitmap(size, new Vector(96, 96), shared.Address, shared.Dispose);
            Fill(frame, Colors.Red);
            X11Picture.Put(target, screen, frame, shared, [new PixelRect(size)]);
            shared?.Wait();
            Fill(frame, Colors.Blue);
            PixelRect[] changed = [new(2, 3, 5, 4), new(10, 0, 3, 3)];
            X11Picture.Put(target, screen, frame, shared, changed);

            var seen = Pixels(target, size);
            for (var i = 0; i < seen.Length; i++)
            {
                var at = new PixelPoint(i % size.Width, i / size.Width);
                Assert.Equal(changed.Any(r => r.ContainsExclusive(at)) ? 0x0000FFu : 0xFF0000u, seen[i]);
            }
        });
    }

    // A server that is busy has read nothing yet when the next frame begins.
    [Fact]
    public async Task A_frame_waits_until_the_server_has_read_the_previous_one()
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(() =>
        {
            XServer.Connect();
            var (display, size) = (X11Connection.Display, new PixelSize(1000, 1000));
            var screen = Xlib.XDefaultScreen(display);
            var target = XCreatePixmap(display, Xlib.XRootWindow(display, screen), 1000, 1000, (uint)Xlib.XDefaultDepth(display, screen));
            using var shared = X11SharedPixels.Create(size);
            using var frame = new SkiaBitmap(size, new Vector(96, 96), shared!.Address, shared.Dispose);
            for (var i = 0; i < 10; i++)
            {
                Fill(frame, Colors.Red);
                X11Picture.Put(target, screen, frame, shared, [new PixelRect(size)]);
                shared.Wait();
                Fill(frame, Colors.Blue);
                Assert.Equal(-1, Pixels(target, size).AsSpan().IndexOfAnyExcept(0xFF0000u));
            }
        });
    }

    // As a server on another computer, which has no such segment.
    [Fact]
    public async Task A_server_that_refuses_a_segment_does_not_end_the_program()
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(() =>
        {
            XServer.Connect();
            Assert.False(X11Connection.Accepts(AttachNothing));
            Assert.True(X11Connection.Accepts(() => { }));
        });

        static unsafe void AttachNothing()
        {
            var segment = new XShm.Segment { Id = -1 };
            _ = XShm.XShmAttach(X11Connection.Display, &segment);
        }
    }

    [Fact]
    public async Task Shared_memory_is_gone_with_its_frame_and_marked_for_removal_before()
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(() =>
        {
            XServer.Connect();
            using (X11SharedPixels.Create(new(20, 10)))
            {
                // Both are attached, and the bit SHM_DEST is set: the system removes it with the last of them.
                var (mode, attached) = Assert.Single(SharedMemory.Of(Environment.ProcessId));
                Assert.Equal((0x200, 2), (mode & 0x200, attached));
            }

            _ = Xlib.XSync(X11Connection.Display, 0);
            Assert.Empty(SharedMemory.Of(Environment.ProcessId));
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
