using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Memory for the clipboard, and a timer that a message loop can wait for.</summary>
internal static unsafe partial class Kernel32
{
    /// <summary>For <see cref="GlobalAlloc"/>: what the clipboard demands.</summary>
    public const uint Movable = 2;

    /// <summary>For <see cref="CreateWaitableTimer"/>: exact to less than a millisecond
    /// (Windows 10 1803), and all rights.</summary>
    public const uint Exact = 2, AllAccess = 0x1F0003;

    private const string Library = "kernel32";

    [LibraryImport(Library)] public static partial nint GlobalAlloc(uint flags, nuint bytes);
    [LibraryImport(Library)] public static partial nint GlobalFree(nint memory);
    [LibraryImport(Library)] public static partial nint GlobalLock(nint memory);
    [LibraryImport(Library)] public static partial int GlobalUnlock(nint memory);
    [LibraryImport(Library)] public static partial nuint GlobalSize(nint memory);
    [LibraryImport(Library, EntryPoint = "CreateWaitableTimerExW")]
    public static partial nint CreateWaitableTimer(nint security, nint name, uint flags, uint access);
    [LibraryImport(Library)]
    public static partial int SetWaitableTimer(nint timer, long* due, int period, nint routine, nint argument, int resumes);
    [LibraryImport(Library, EntryPoint = "GetModuleHandleW")] public static partial nint GetModuleHandle(nint name);
}
