using Avalonia.Input;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The X server's own cursors (X11/cursorfont.h) for the standard shapes.</summary>
internal static class X11Cursors
{
    private static readonly Dictionary<uint, nint> Made = [];

    /// <summary>The server's cursor for a shape, created once.</summary>
    public static nint Of(StandardCursorType shape)
    {
        var glyph = Glyph(shape);
        if (!Made.TryGetValue(glyph, out var cursor))
        {
            Made[glyph] = cursor = Xlib.XCreateFontCursor(X11Connection.Display, glyph);
        }

        return cursor;
    }

    private static uint Glyph(StandardCursorType shape) => shape switch
    {
        StandardCursorType.Ibeam => 152,
        StandardCursorType.Wait => 150,
        StandardCursorType.Cross => 34,
        StandardCursorType.Hand => 60,
        StandardCursorType.SizeAll => 52,
        StandardCursorType.SizeNorthSouth or StandardCursorType.TopSide or StandardCursorType.BottomSide => 116,
        StandardCursorType.SizeWestEast or StandardCursorType.LeftSide or StandardCursorType.RightSide => 108,
        StandardCursorType.Help => 92,
        _ => 68,
    };
}
