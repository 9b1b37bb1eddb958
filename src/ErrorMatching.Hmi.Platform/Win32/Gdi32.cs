using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The few entry points of gdi32 that copy pixels to a window.</summary>
internal static unsafe partial class Gdi32
{
    /// <summary>For <see cref="BitBlt"/>: the source as it is (SRCCOPY).</summary>
    public const uint Copy = 0x00CC0020;

    private const string Library = "gdi32";

    [LibraryImport(Library)] public static partial nint CreateCompatibleDC(nint dc);
    [LibraryImport(Library)] public static partial int DeleteDC(nint dc);
    [LibraryImport(Library)]
    public static partial nint CreateDIBSection(nint dc, BitmapHeader* info, uint usage, nint* bits, nint section, uint offset);
    [LibraryImport(Library)] public static partial nint SelectObject(nint dc, nint handle);
    [LibraryImport(Library)] public static partial int DeleteObject(nint handle);
    [LibraryImport(Library)]
    public static partial int BitBlt(nint to, int x, int y, int width, int height, nint from, int fromX, int fromY, uint operation);
    [LibraryImport(Library)] public static partial int GdiFlush();

    /// <summary>BITMAPINFOHEADER.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct BitmapHeader
    {
        public int Bytes, Width, Height;
        public ushort Planes, Bits;
        public int Compression, ImageBytes, HorizontalResolution, VerticalResolution, Used, Important;
    }
}
