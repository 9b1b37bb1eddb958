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

    // A selection that is asked for: by whom, which, as what, where it is to be put. In the answer all but the window stand one place further in front.
    [FieldOffset(40)] public nint Requestor;
    [FieldOffset(48)] public nint Selection;
    [FieldOffset(56)] public nint Target;
    [FieldOffset(64)] public nint Property;
    [FieldOffset(72)] public nint Time;
    [FieldOffset(40)] public nint AnswerSelection;
    [FieldOffset(48)] public nint AnswerTarget;
    [FieldOffset(56)] public nint AnswerProperty;
    [FieldOffset(64)] public nint AnswerTime;

    // A property that was changed, and whether it was deleted.
    [FieldOffset(40)] public nint Atom;
    [FieldOffset(56)] public int PropertyState;

    // The size of a window that was changed.
    [FieldOffset(56)] public int Width;
    [FieldOffset(60)] public int Height;

    // Where a key or button was pressed, with what, and which.
    [FieldOffset(64)] public int X;
    [FieldOffset(68)] public int Y;
    [FieldOffset(80)] public uint State;
    [FieldOffset(84)] public uint Detail;
}
