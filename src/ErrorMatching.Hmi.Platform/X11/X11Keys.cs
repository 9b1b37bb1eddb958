using Avalonia.Input;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Translates X11's keys and buttons to Avalonia's.</summary>
internal static class X11Keys
{
    private const uint ShiftBit = 1, ControlBit = 4, AltBit = 8, MetaBit = 0x40, LeftBit = 0x100, MiddleBit = 0x200, RightBit = 0x400;

    /// <summary>The button with a number, 1 to 3.</summary>
    public static RawInputModifiers Button(uint button) => button switch
    {
        1 => RawInputModifiers.LeftMouseButton,
        2 => RawInputModifiers.MiddleMouseButton,
        _ => RawInputModifiers.RightMouseButton,
    };

    /// <summary>The modifiers and buttons that were held.</summary>
    public static RawInputModifiers Modifiers(uint state) =>
        If(state, ShiftBit, RawInputModifiers.Shift) | If(state, ControlBit, RawInputModifiers.Control)
            | If(state, AltBit, RawInputModifiers.Alt) | If(state, MetaBit, RawInputModifiers.Meta)
        | If(state, LeftBit, RawInputModifiers.LeftMouseButton) | If(state, MiddleBit, RawInputModifiers.MiddleMouseButton)
            | If(state, RightBit, RawInputModifiers.RightMouseButton);

    /// <summary>The key of a keysym (X11/keysymdef.h); <see cref="Key.None"/> for one that only types text.</summary>
    public static Key Of(uint keysym) => keysym switch
    {
        >= 'a' and <= 'z' => Key.A + (int)(keysym - 'a'),
        >= 'A' and <= 'Z' => Key.A + (int)(keysym - 'A'),
        >= '0' and <= '9' => Key.D0 + (int)(keysym - '0'),
        >= 0xffb0 and <= 0xffb9 => Key.NumPad0 + (int)(keysym - 0xffb0),
        >= 0xffbe and <= 0xffc9 => Key.F1 + (int)(keysym - 0xffbe),
        ' ' => Key.Space,
        '.' => Key.OemPeriod,
        ',' => Key.OemComma,
        '-' => Key.OemMinus,
        '+' => Key.OemPlus,
        0xff08 => Key.Back,
        0xff09 or 0xfe20 => Key.Tab,
        0xff0d or 0xff8d => Key.Enter,
        0xff1b => Key.Escape,
        0xffff => Key.Delete,
        0xff50 => Key.Home,
        0xff51 => Key.Left,
        0xff52 => Key.Up,
        0xff53 => Key.Right,
        0xff54 => Key.Down,
        0xff55 => Key.PageUp,
        0xff56 => Key.PageDown,
        0xff57 => Key.End,
        0xff63 => Key.Insert,
        0xffe1 => Key.LeftShift,
        0xffe2 => Key.RightShift,
        0xffe3 => Key.LeftCtrl,
        0xffe4 => Key.RightCtrl,
        0xffe9 => Key.LeftAlt,
        0xffea => Key.RightAlt,
        _ => Key.None,
    };

    private static RawInputModifiers If(uint state, uint bit, RawInputModifiers then) => (state & bit) == 0 ? RawInputModifiers.None : then;
}
