using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The few entry points of user32 that a window needs.</summary>
internal static unsafe partial class User32
{
    public const uint Overlapped = 0x00CF0000, ClipChildren = 0x02000000, Popup = 0x80000000, Visible = 0x10000000;

    /// <summary>For <see cref="CreateWindow"/>: the system chooses, and a window that only receives messages.</summary>
    public const int Anywhere = unchecked((int)0x80000000), MessagesOnly = -3;

    /// <summary>For <see cref="ShowWindow"/>.</summary>
    public const int Hide = 0, ShowNormal = 1, ShowMaximized = 3, ShowNotActive = 4, ShowAsIs = 5, ShowMinimized = 6;

    /// <summary>For <see cref="SetWindowPos"/>.</summary>
    public const uint KeepSize = 1, KeepPlace = 2, KeepOrder = 4, NotActive = 0x10, FrameChanged = 0x20;

    /// <summary>For <see cref="SetWindowLong"/>: the style.</summary>
    public const int Style = -16;

    /// <summary>For <see cref="GetParameter"/>: <see cref="HighContrast"/>, and whether things move by themselves (a BOOL).</summary>
    public const uint GetHighContrast = 0x42, GetAnimation = 0x1042;

    private const string Library = "user32";

    [LibraryImport(Library, EntryPoint = "RegisterClassExW")] public static partial ushort RegisterClass(WindowClass* description);
    [LibraryImport(Library, EntryPoint = "CreateWindowExW", StringMarshalling = StringMarshalling.Utf16)]
    public static partial nint CreateWindow(
        uint extended,
        string name,
        string title,
        uint style,
        int x,
        int y,
        int width,
        int height,
        nint parent,
        nint menu,
        nint instance,
        nint data);
    [LibraryImport(Library)] public static partial int DestroyWindow(nint window);
    [LibraryImport(Library, EntryPoint = "DefWindowProcW")] public static partial nint Default(nint window, uint message, nint w, nint l);
    [LibraryImport(Library, EntryPoint = "PeekMessageW")]
    public static partial int PeekMessage(Message* message, nint window, uint first, uint last, uint removes);
    [LibraryImport(Library)] public static partial int TranslateMessage(Message* message);
    [LibraryImport(Library, EntryPoint = "DispatchMessageW")] public static partial nint DispatchMessage(Message* message);
    [LibraryImport(Library, EntryPoint = "PostMessageW")] public static partial int PostMessage(nint window, uint message, nint w, nint l);
    [LibraryImport(Library)] public static partial int GetMessageTime();
    [LibraryImport(Library)]
    public static partial uint MsgWaitForMultipleObjectsEx(uint count, nint* handles, uint milliseconds, uint wakes, uint flags);
    [LibraryImport(Library)] public static partial nint SetTimer(nint window, nint id, uint milliseconds, nint procedure);
    [LibraryImport(Library)] public static partial int KillTimer(nint window, nint id);
    [LibraryImport(Library)] public static partial int ShowWindow(nint window, int how);
    [LibraryImport(Library)] public static partial int IsIconic(nint window);
    [LibraryImport(Library)] public static partial int IsWindowVisible(nint window);
    [LibraryImport(Library)] public static partial int SetForegroundWindow(nint window);
    [LibraryImport(Library, EntryPoint = "SetWindowTextW", StringMarshalling = StringMarshalling.Utf16)]
    public static partial int SetWindowText(nint window, string text);
    [LibraryImport(Library)] public static partial nint BeginPaint(nint window, PaintArea* paint);
    [LibraryImport(Library)] public static partial int EndPaint(nint window, PaintArea* paint);
    [LibraryImport(Library)] public static partial nint GetDC(nint window);
    [LibraryImport(Library)] public static partial int ReleaseDC(nint window, nint dc);
    [LibraryImport(Library)] public static partial int GetClientRect(nint window, Rect* rect);
    [LibraryImport(Library)] public static partial int GetWindowRect(nint window, Rect* rect);
    [LibraryImport(Library)] public static partial int ClientToScreen(nint window, Pixel* place);
    [LibraryImport(Library)] public static partial int ScreenToClient(nint window, Pixel* place);
    [LibraryImport(Library)]
    public static partial int SetWindowPos(nint window, nint after, int x, int y, int width, int height, uint flags);
    [LibraryImport(Library, EntryPoint = "SetWindowLongPtrW")]
    public static partial nint SetWindowLong(nint window, int index, nint value);
    [LibraryImport(Library)]
    public static partial int AdjustWindowRectExForDpi(Rect* rect, uint style, int hasMenu, uint extended, uint dpi);
    [LibraryImport(Library)] public static partial uint GetDpiForWindow(nint window);
    [LibraryImport(Library)] public static partial int SetProcessDpiAwarenessContext(nint context);
    [LibraryImport(Library)] public static partial nint SetCapture(nint window);
    [LibraryImport(Library)] public static partial int ReleaseCapture();
    [LibraryImport(Library)] public static partial int TrackMouseEvent(Tracking* tracking);
    [LibraryImport(Library)] public static partial short GetKeyState(int key);
    [LibraryImport(Library, EntryPoint = "MapVirtualKeyW")] public static partial uint MapVirtualKey(uint code, uint kind);
    [LibraryImport(Library, EntryPoint = "LoadCursorW")] public static partial nint LoadCursor(nint instance, nint name);
    [LibraryImport(Library)] public static partial nint SetCursor(nint cursor);
    [LibraryImport(Library, EntryPoint = "LoadImageW")]
    public static partial nint LoadImage(nint instance, nint name, uint kind, int width, int height, uint flags);
    [LibraryImport(Library)] public static partial int GetSystemMetrics(int index);
    [LibraryImport(Library)] public static partial nint MonitorFromWindow(nint window, uint otherwise);
    [LibraryImport(Library, EntryPoint = "GetMonitorInfoW")] public static partial int GetMonitorInfo(nint monitor, Monitor* info);
    [LibraryImport(Library)] public static partial int GetPointerType(uint pointer, int* type);
    [LibraryImport(Library)] public static partial uint GetSysColor(int index);
    [LibraryImport(Library, EntryPoint = "SystemParametersInfoW")]
    public static partial int GetParameter(uint which, uint bytes, void* value, uint changes);
    [LibraryImport(Library)] public static partial int OpenClipboard(nint window);
    [LibraryImport(Library)] public static partial int CloseClipboard();
    [LibraryImport(Library)] public static partial int EmptyClipboard();
    [LibraryImport(Library)] public static partial nint GetClipboardData(uint format);
    [LibraryImport(Library)] public static partial nint SetClipboardData(uint format, nint memory);

    /// <summary>WNDCLASSEXW.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct WindowClass
    {
        public uint Bytes, Style;
        public delegate* unmanaged[Stdcall]<nint, uint, nint, nint, nint> Procedure;
        public int ClassExtra, WindowExtra;
        public nint Instance, Icon, Cursor, Background;
        public char* Menu, Name;
        public nint SmallIcon;
    }

    /// <summary>MSG.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Message
    {
        public nint Window;
        public uint Kind;
        public nint W, L;
        public uint Time;
        public int X, Y;
    }

    /// <summary>RECT.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Rect
    {
        public int Left, Top, Right, Bottom;
        public readonly int Width => Right - Left;
        public readonly int Height => Bottom - Top;
    }

    /// <summary>POINT.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Pixel
    {
        public int X, Y;
    }

    /// <summary>MINMAXINFO.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Limits
    {
        public Pixel Reserved, MaximizedSize, MaximizedPlace, Least, Most;
    }

    /// <summary>PAINTSTRUCT.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PaintArea
    {
        public nint Dc;
        public int IsErased;
        public Rect Area;
        public int Restores, Updates;
        public Reserved Rest;

        [InlineArray(32)]
        public struct Reserved
        {
            private byte _first;
        }
    }

    /// <summary>MONITORINFO.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Monitor
    {
        public int Bytes;
        public Rect All, Work;
        public uint Flags;
    }

    /// <summary>TRACKMOUSEEVENT.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Tracking
    {
        public int Bytes;
        public uint Flags;
        public nint Window;
        public uint Hover;
    }

    /// <summary>HIGHCONTRASTW.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HighContrast
    {
        public uint Bytes, Flags;
        public char* Scheme;
    }
}
