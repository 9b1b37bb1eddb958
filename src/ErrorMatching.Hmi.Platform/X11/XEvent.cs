using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>XEvent: the union of the members used here, in its 64-bit layout.</summary>
[StructLayout(LayoutKind.Explicit, Size = 192)]
internal struct XEvent
{
    [FieldOffset(0)] public int Type;
    [FieldOffset(32)] public nint Window;

    // An event with data of an extension: whose, which, and where the data are.
    [FieldOffset(32)] public int Extension;
    [FieldOffset(36)] public int ExtensionKind;
    [FieldOffset(48)] public nint Cookie;

    // Which window lost the focus, and to which.
    [FieldOffset(44)] public int FocusDetail;

    // A message's type and data.
    [FieldOffset(40)] public nint MessageType;
    [FieldOffset(48)] public int Format;
    [FieldOffset(56)] public nint Data0;
    [FieldOffset(64)] public nint Data1;
    [FieldOffset(72)] public nint Data2;

    // A request for a selection: the requestor, the selection, the target type, the property for the result. In the reply, all but the
    // window are one position earlier.
    [FieldOffset(40)] public nint Requestor;
    [FieldOffset(48)] public nint Selection;
    [FieldOffset(56)] public nint Target;
    [FieldOffset(64)] public nint Property;
    [FieldOffset(72)] public nint Time;
    [FieldOffset(40)] public nint AnswerSelection;
    [FieldOffset(48)] public nint AnswerTarget;
    [FieldOffset(56)] public nint AnswerProperty;
    [FieldOffset(64)] public nint AnswerTime;

    // A property that changed, and whether it was deleted.
    [FieldOffset(40)] public nint Atom;
    [FieldOffset(56)] public int PropertyState;

    // The new size of a window.
    [FieldOffset(56)] public int Width;
    [FieldOffset(60)] public int Height;

    // The time of a key or button press in the server's milliseconds, its position, the modifiers, and the key or button.
    [FieldOffset(56)] public nint At;
    [FieldOffset(64)] public int X;
    [FieldOffset(68)] public int Y;
    [FieldOffset(80)] public uint State;
    [FieldOffset(84)] public uint Detail;
}
