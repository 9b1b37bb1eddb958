using Avalonia;
using Avalonia.Input;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>Cursors as names of standard shapes, which X11 knows. Cursors from pictures are not needed: they are arrows.</summary>
internal sealed class ShapeCursors : ICursorFactory
{
    /// <inheritdoc/>
    public ICursorImpl GetCursor(StandardCursorType cursorType) => new ShapeCursor(cursorType);

    /// <inheritdoc/>
    public ICursorImpl CreateCursor(Bitmap cursor, PixelPoint hotSpot) => new ShapeCursor(StandardCursorType.Arrow);
}
