using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi;

/// <summary>Shows a <see cref="PixelCanvas"/> as a bitmap, for drawings with too many lines or dots to draw as shapes.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage(
    "Design", "CA1001", Justification = "A drawing lets its picture go whenever it leaves the screen, and may come back.")]
internal sealed class PixelLayer
{
    private WriteableBitmap? _bitmap;

    public PixelCanvas Canvas { get; } = new();

    /// <summary>The pixel value of a solid color brush; 0 for other brushes.</summary>
    public static int ColorOf(IBrush? brush) =>
        brush is ISolidColorBrush { Color: var c } ? unchecked((int)((0xFFu << 24) | ((uint)c.R << 16) | ((uint)c.G << 8) | c.B)) : 0;

    /// <summary>Copies the canvas to the bitmap, after each of its drawings.</summary>
    public void Take()
    {
        var size = new PixelSize(Canvas.Width, Canvas.Height);
        var isNew = _bitmap?.PixelSize != size;
        if (_bitmap is null || isNew)
        {
            _bitmap?.Dispose();
            _bitmap = new(size, new(96, 96), PixelFormat.Bgra8888, AlphaFormat.Premul);
        }

        using var locked = _bitmap.Lock();
        foreach (var rect in isNew ? [new(size)] : Canvas.Changed)
        {
            for (var row = rect.Y; row < rect.Bottom; row++)
            {
                var to = locked.Address + (row * locked.RowBytes) + (rect.X * sizeof(int));
                Marshal.Copy(Canvas.Memory, (row * size.Width) + rect.X, to, rect.Width);
            }
        }
    }

    /// <summary>Draws the bitmap.</summary>
    /// <param name="context">Where to draw.</param>
    /// <param name="place">Its position and size in screen units.</param>
    public void Show(DrawingContext context, Rect place)
    {
        if (_bitmap is null)
        {
            return;
        }

        // Sharp edges, and the whole bitmap at once: each part by itself would take ten times as long.
        using var options = context.PushRenderOptions(
            new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None, EdgeMode = EdgeMode.Aliased });
        context.DrawImage(_bitmap, place);
    }

    /// <summary>Releases the bitmap; the next call of <see cref="Take"/> creates a new one.</summary>
    public void LetGo()
    {
        _bitmap?.Dispose();
        _bitmap = null;
    }
}
