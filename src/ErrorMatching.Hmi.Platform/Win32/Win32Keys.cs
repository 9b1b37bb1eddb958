using Avalonia.Input;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Translates Windows' keys and buttons to Avalonia's.</summary>
internal static class Win32Keys
{
    private const int Left = 1, Right = 2, Middle = 4, Shift = 0x10, Control = 0x11, Alt = 0x12, LeftMeta = 0x5B, RightMeta = 0x5C;
    private const int LeftShift = 0xA0, RightShift = 0xA1;

    // MAPVK_VSC_TO_VK_EX: tells left keys from right ones.
    private const uint KeyOfScanCode = 3;

    /// <summary>The modifiers and buttons that are held, as of the message that is being handled.</summary>
    public static RawInputModifiers Held =>
        If(Shift, RawInputModifiers.Shift) | If(Control, RawInputModifiers.Control) | If(Alt, RawInputModifiers.Alt)
            | If(LeftMeta, RawInputModifiers.Meta) | If(RightMeta, RawInputModifiers.Meta)
        | If(Left, RawInputModifiers.LeftMouseButton) | If(Right, RawInputModifiers.RightMouseButton)
            | If(Middle, RawInputModifiers.MiddleMouseButton);

    /// <summary>The key of a message.</summary>
    /// <param name="key">Its virtual key.</param>
    /// <param name="data">What else the message says.</param>
    public static Key Of(int key, nint data)
    {
        var isExtended = (data & (1 << 24)) != 0;
        return key switch
        {
            Shift => User32.MapVirtualKey((uint)(data >> 16) & 0xFF, KeyOfScanCode) == RightShift ? Key.RightShift : Key.LeftShift,
            Control => isExtended ? Key.RightCtrl : Key.LeftCtrl,
            Alt => isExtended ? Key.RightAlt : Key.LeftAlt,
            _ => Of(key),
        };
    }

    /// <summary>The key of a virtual key; <see cref="Key.None"/> for one that only types text.</summary>
    public static Key Of(int key) => key switch
    {
        >= 'A' and <= 'Z' => Key.A + (key - 'A'),
        >= '0' and <= '9' => Key.D0 + (key - '0'),
        >= 0x60 and <= 0x69 => Key.NumPad0 + (key - 0x60),
        >= 0x70 and <= 0x87 => Key.F1 + (key - 0x70),
        0x08 => Key.Back,
        0x09 => Key.Tab,
        0x0D => Key.Enter,
        0x13 => Key.Pause,
        0x14 => Key.CapsLock,
        0x1B => Key.Escape,
        0x20 => Key.Space,
        0x21 => Key.PageUp,
        0x22 => Key.PageDown,
        0x23 => Key.End,
        0x24 => Key.Home,
        0x25 => Key.Left,
        0x26 => Key.Up,
        0x27 => Key.Right,
        0x28 => Key.Down,
        0x2C => Key.PrintScreen,
        0x2D => Key.Insert,
        0x2E => Key.Delete,
        LeftMeta => Key.LWin,
        RightMeta => Key.RWin,
        0x5D => Key.Apps,
        0x6A => Key.Multiply,
        0x6B => Key.Add,
        0x6D => Key.Subtract,
        0x6E => Key.Decimal,
        0x6F => Key.Divide,
        0x90 => Key.NumLock,
        0x91 => Key.Scroll,
        LeftShift => Key.LeftShift,
        RightShift => Key.RightShift,
        0xBA => Key.OemSemicolon,
        0xBB => Key.OemPlus,
        0xBC => Key.OemComma,
        0xBD => Key.OemMinus,
        0xBE => Key.OemPeriod,
        0xBF => Key.OemQuestion,
        0xC0 => Key.OemTilde,
        0xDB => Key.OemOpenBrackets,
        0xDC => Key.OemPipe,
        0xDD => Key.OemCloseBrackets,
        0xDE => Key.OemQuotes,
        0xE2 => Key.OemBackslash,
        0xE5 => Key.ImeProcessed,
        _ => Key.None,
    };

    private static RawInputModifiers If(int key, RawInputModifiers then) => User32.GetKeyState(key) < 0 ? then : RawInputModifiers.None;
}
