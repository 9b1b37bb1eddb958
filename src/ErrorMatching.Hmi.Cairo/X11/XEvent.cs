using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>XEvent: the union of the members used here, in its layout on 64 bits.</summary>
[StructLayout(LayoutKind.Explicit, Size = 192)]
internal struct XEvent
{
    [FieldOffset(0)] public int Type;
    [FieldOffset(32)] public nint Window;

    // A message's kind and its data.
    [FieldOffset(40)] public nint MessageType;
    [FieldOffset(48)] public int Format;
    [FieldOffset(56)] public nint Data0;
    [FieldOffset(64)] public nint Data1;
    [FieldOffset(72)] public nint Data2;

    // The size of a window that was changed.
    [FieldOffset(56)] public int Width;
    [FieldOffset(60)] public int Height;

    // Where a key or button was pressed, with what, and which.
    [FieldOffset(64)] public int X;
    [FieldOffset(68)] public int Y;
    [FieldOffset(80)] public uint State;
    [FieldOffset(84)] public uint Detail;
}
