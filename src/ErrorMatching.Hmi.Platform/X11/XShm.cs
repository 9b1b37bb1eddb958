using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The entry points for pixels in memory that a program shares with the X server on the same computer (Debian:
/// libxext6).</summary>
internal static unsafe partial class XShm
{
    public const string Library = "libXext.so.6";

    /// <summary>For <see cref="shmget"/>: a segment of this process, created, that only this user's programs and the superuser's may
    /// attach.</summary>
    public const int Private = 0, Create = 0x200 | 0x180;

    /// <summary>For <see cref="shmctl"/>.</summary>
    public const int Remove = 0, State = 2;

    [LibraryImport(Library)] public static partial int XShmQueryExtension(nint display);
    [LibraryImport(Library)] public static partial int XShmAttach(nint display, Segment* segment);
    [LibraryImport(Library)] public static partial int XShmDetach(nint display, Segment* segment);
    [LibraryImport(Library)]
    public static partial XImage* XShmCreateImage(
        nint display, nint visual, uint depth, int format, nint data, Segment* segment, uint width, uint height);
    [LibraryImport(Library)]
    public static partial int XShmPutImage(
        nint display,
        nint drawable,
        nint gc,
        XImage* image,
        int fromX,
        int fromY,
        int toX,
        int toY,
        uint width,
        uint height,
        int sendsEvent);
    [LibraryImport("libc")] public static partial int shmget(int key, nuint size, int flags);
    [LibraryImport("libc")] public static partial nint shmat(int id, nint address, int flags);
    [LibraryImport("libc")] public static partial int shmdt(nint address);
    [LibraryImport("libc")] public static partial int shmctl(int id, int command, SegmentState* state);

    /// <summary>XShmSegmentInfo.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Segment
    {
        public nint Server;
        public int Id;
        public nint Address;
        public int IsReadOnly;
    }

    /// <summary>shmid_ds of the C library, in its 64-bit layout.</summary>
    [StructLayout(LayoutKind.Explicit, Size = 112)]
    public struct SegmentState
    {
        [FieldOffset(88)] public nuint Attached;
    }
}
