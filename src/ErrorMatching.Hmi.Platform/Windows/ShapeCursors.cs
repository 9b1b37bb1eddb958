using Avalonia;
using Avalonia.Input;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Cursors as names of standard shapes, which each system has. Cursors from pictures are not needed; they become arrows.</summary>
internal sealed class ShapeCursors : ICursorFactory
{
    public ICursorImpl GetCursor(StandardCursorType cursorType) => new ShapeCursor(cursorType);

    public ICursorImpl CreateCursor(Bitmap cursor, PixelPoint hotSpot) => new ShapeCursor(StandardCursorType.Arrow);
}

/// <summary>A cursor identified by its shape.</summary>
internal sealed class ShapeCursor(StandardCursorType shape) : ICursorImpl
{
    /// <summary>The shape.</summary>
    public StandardCursorType Shape { get; } = shape;

    public void Dispose()
    {
        // It has no native resource.
    }
}
