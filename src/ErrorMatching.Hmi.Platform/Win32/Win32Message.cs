namespace ErrorMatching.Hmi.Platform;

/// <summary>The messages (WM_...) that a station's window handles.</summary>
internal static class Win32Message
{
    public const uint Size = 0x05, SetFocus = 0x07, KillFocus = 0x08, Paint = 0x0F, Close = 0x10, EraseBackground = 0x14,
        ColorsChanged = 0x15, SessionEnds = 0x16, SettingChanged = 0x1A, SetCursor = 0x20,
        GetLimits = 0x24, GetObject = 0x3D, PlaceChanged = 0x47, DisplayChanged = 0x7E;

    public const uint KeyDown = 0x100, KeyUp = 0x101, Char = 0x102, SystemKeyDown = 0x104, SystemKeyUp = 0x105, SystemChar = 0x106,
        SystemCommand = 0x112, Timer = 0x113;

    public const uint MouseMove = 0x200, LeftDown = 0x201, LeftUp = 0x202, RightDown = 0x204, RightUp = 0x205, MiddleDown = 0x207,
        MiddleUp = 0x208, Wheel = 0x20A, SidewaysWheel = 0x20E, MouseLeaves = 0x2A3;

    public const uint MenuBegins = 0x211, MenuEnds = 0x212, CaptureChanged = 0x215, MoveBegins = 0x231, MoveEnds = 0x232;

    public const uint PointerUpdate = 0x245, PointerDown = 0x246, PointerUp = 0x247, PointerCaptureChanged = 0x24C;

    public const uint CompositionBegins = 0x10D, CompositionEnds = 0x10E, Composition = 0x10F, InputContext = 0x281;

    public const uint DpiChanged = 0x2E0;

    /// <summary>Our own (WM_APP and one): the dispatcher has work.</summary>
    public const uint Work = 0x8001;
}
