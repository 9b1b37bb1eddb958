using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

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
