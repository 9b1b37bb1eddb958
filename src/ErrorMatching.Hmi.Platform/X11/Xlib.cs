using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The few Xlib entry points that a window needs (Debian: libx11-6).</summary>
internal static unsafe partial class Xlib
{
    public const string Library = "libX11.so.6";
    public const int KeyPress = 2, KeyRelease = 3, ButtonPress = 4, ButtonRelease = 5, MotionNotify = 6, LeaveNotify = 8, FocusIn = 9,
        FocusOut = 10;
    public const int Expose = 12, ConfigureNotify = 22, PropertyNotify = 28, SelectionClear = 29, SelectionRequest = 30,
        SelectionNotify = 31, ClientMessage = 33, GenericEvent = 35;

    /// <summary>The focus is that of the window under the pointer, and the pointer left.</summary>
    public const int FocusOfPointer = 5;

    public const int SubstructureMask = (1 << 19) | (1 << 20);

    /// <summary>Keys, buttons, motion, leaving, exposure, structure and focus.</summary>
    public const nint EventMask = 1 | 2 | 4 | 8 | (1 << 5) | (1 << 6) | (1 << 15) | (1 << 17) | (1 << 21);

    /// <summary>Property changes.</summary>
    public const nint PropertyMask = 1 << 22;

    [LibraryImport(Library)] public static partial int XSetSelectionOwner(nint display, nint selection, nint owner, nint time);
    [LibraryImport(Library)] public static partial nint XGetSelectionOwner(nint display, nint selection);
    [LibraryImport(Library)]
    public static partial int XConvertSelection(nint display, nint selection, nint target, nint property, nint requestor, nint time);
    [LibraryImport(Library)]
    public static partial int XGetWindowProperty(
        nint display,
        nint window,
        nint property,
        nint offset,
        nint length,
        int delete,
        nint wanted,
        out nint type,
        out int format,
        out nuint items,
        out nuint left,
        out byte* data);
    [LibraryImport(Library, EntryPoint = "XChangeProperty")]
    public static partial int XChangeBytes(
        nint display, nint window, nint property, nint type, int format, int mode, byte* data, int elements);
    [LibraryImport(Library)] public static partial nint XMaxRequestSize(nint display);
    [LibraryImport(Library)] public static partial nint XExtendedMaxRequestSize(nint display);
    [LibraryImport(Library)] public static partial int XFree(void* data);
    [LibraryImport(Library)]
    public static partial delegate* unmanaged[Cdecl]<nint, byte*,
    int> XSetErrorHandler(delegate* unmanaged[Cdecl]<nint, byte*, int> handler);
    [LibraryImport("libc")] public static partial int poll(ref PollFd fds, nuint count, int timeout);
    [LibraryImport(Library)] public static partial int XConnectionNumber(nint display);
    [LibraryImport(Library)] public static partial int XPending(nint display);
    [LibraryImport(Library)] public static partial int XEventsQueued(nint display, int mode);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)] public static partial nint XOpenDisplay(string? name);
    [LibraryImport(Library)] public static partial int XDefaultScreen(nint display);
    [LibraryImport(Library)] public static partial int XDisplayWidth(nint display, int screen);
    [LibraryImport(Library)] public static partial int XDisplayHeight(nint display, int screen);
    [LibraryImport(Library)] public static partial nint XDefaultVisual(nint display, int screen);
    [LibraryImport(Library)] public static partial nint XRootWindow(nint display, int screen);
    [LibraryImport(Library)]
    public static partial nint XCreateSimpleWindow(
        nint display, nint parent, int x, int y, uint width, uint height, uint border, nuint borderPixel, nuint background);
    [LibraryImport(Library)] public static partial int XSelectInput(nint display, nint window, nint mask);
    [LibraryImport(Library)] public static partial int XMapRaised(nint display, nint window);
    [LibraryImport(Library)] public static partial int XUnmapWindow(nint display, nint window);
    [LibraryImport(Library)] public static partial int XDestroyWindow(nint display, nint window);
    [LibraryImport(Library)] public static partial int XResizeWindow(nint display, nint window, uint width, uint height);
    [LibraryImport(Library)] public static partial int XMoveResizeWindow(nint display, nint window, int x, int y, uint width, uint height);
    [LibraryImport(Library)] public static partial int XIconifyWindow(nint display, nint window, int screen);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int XStoreName(nint display, nint window, string name);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint XInternAtom(nint display, string name, int onlyIfExists);
    [LibraryImport(Library)]
    public static partial int XChangeProperty(
        nint display, nint window, nint property, nint type, int format, int mode, nint* data, int elements);
    [LibraryImport(Library)] public static partial int XDeleteProperty(nint display, nint window, nint property);
    [LibraryImport(Library)] public static partial int XSetWMProtocols(nint display, nint window, nint* protocols, int count);
    [LibraryImport(Library)] public static partial void XSetWMNormalHints(nint display, nint window, ref XSizeHints hints);
    [LibraryImport(Library)] public static partial int XSendEvent(nint display, nint window, int propagate, nint mask, ref XEvent e);
    [LibraryImport(Library)] public static partial int XNextEvent(nint display, out XEvent e);
    [LibraryImport(Library)] public static partial int XGetEventData(nint display, ref XEvent e);
    [LibraryImport(Library)] public static partial void XFreeEventData(nint display, ref XEvent e);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int XQueryExtension(nint display, string name, out int opcode, out int firstEvent, out int firstError);
    [LibraryImport(Library)] public static partial int XSync(nint display, int discards);
    [LibraryImport(Library)] public static partial int XFlush(nint display);
    [LibraryImport(Library)] public static partial int XLookupString(ref XEvent e, byte* buffer, int size, out nuint keysym, nint compose);
    [LibraryImport(Library)] public static partial nint XCreateFontCursor(nint display, uint shape);
    [LibraryImport(Library)] public static partial int XDefineCursor(nint display, nint window, nint cursor);
    [LibraryImport(Library)] public static partial int XDefaultDepth(nint display, int screen);
    [LibraryImport(Library)] public static partial nint XDefaultGC(nint display, int screen);
    [LibraryImport(Library)]
    public static partial XImage* XCreateImage(
        nint display, nint visual, uint depth, int format, int offset, nint data, uint width, uint height, int pad, int bytesPerLine);
    [LibraryImport(Library)]
    public static partial int XPutImage(
        nint display, nint drawable, nint gc, XImage* image, int fromX, int fromY, int toX, int toY, uint width, uint height);
}

/// <summary>A file descriptor to wait for, in the layout for <c>poll</c>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct PollFd
{
    public int Fd;
    public short Events;
    public short Returned;
}

/// <summary>XSizeHints in its 64-bit layout: what a window manager should know about a window's size (ICCCM 4.1.2.3).</summary>
[StructLayout(LayoutKind.Explicit, Size = 80)]
internal struct XSizeHints
{
    /// <summary>Set in <see cref="Flags"/> if the smallest size is given.</summary>
    public const nint HasLeast = 1 << 4;

    [FieldOffset(0)] public nint Flags;
    [FieldOffset(24)] public int LeastWidth;
    [FieldOffset(28)] public int LeastHeight;
}
