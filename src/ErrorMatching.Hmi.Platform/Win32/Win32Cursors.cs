using Avalonia.Input;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The system's own cursors for the standard shapes.</summary>
internal static class Win32Cursors
{
    private const int Arrow = 32512, Beam = 32513, Wait = 32514, Cross = 32515, Sideways = 32644, UpDown = 32645, All = 32646, No = 32648,
        Hand = 32649, Help = 32651;

    /// <summary>The cursor for a shape. The system shares it, so it is never freed.</summary>
    public static nint Of(StandardCursorType shape) => User32.LoadCursor(0, shape switch
    {
        StandardCursorType.Ibeam => Beam,
        StandardCursorType.Wait => Wait,
        StandardCursorType.Cross => Cross,
        StandardCursorType.SizeWestEast or StandardCursorType.LeftSide or StandardCursorType.RightSide => Sideways,
        StandardCursorType.SizeNorthSouth or StandardCursorType.TopSide or StandardCursorType.BottomSide => UpDown,
        StandardCursorType.SizeAll => All,
        StandardCursorType.No => No,
        StandardCursorType.Hand => Hand,
        StandardCursorType.Help => Help,
        _ => Arrow,
    });
}
