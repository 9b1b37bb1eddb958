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
    private PixelRect[] _taken = [];

    public PixelCanvas Canvas { get; } = new();

    /// <summary>The pixel value of a solid color brush; 0 for other brushes.</summary>
    public static int ColorOf(IBrush? brush) =>
        brush is ISolidColorBrush { Color: var c } ? unchecked((int)((0xFFu << 24) | ((uint)c.R << 16) | ((uint)c.G << 8) | c.B)) : 0;

    /// <summary>Copies the canvas to the bitmap.</summary>
    public void Take()
    {
        var size = new PixelSize(Canvas.Width, Canvas.Height);
        if (_bitmap?.PixelSize != size)
        {
            _bitmap?.Dispose();
            _bitmap = new(size, new(96, 96), PixelFormat.Bgra8888, AlphaFormat.Premul);
        }

        _taken = [.. Canvas.Touched];
        using var locked = _bitmap.Lock();
        foreach (var rect in _taken)
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

        // Only what was copied; the rest of the bitmap may be of an earlier drawing. Sharp edges: smooth ones would show between parts.
        using var options = context.PushRenderOptions(
            new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None, EdgeMode = EdgeMode.Aliased });
        var (scaleX, scaleY) = (place.Width / _bitmap.PixelSize.Width, place.Height / _bitmap.PixelSize.Height);
        foreach (var rect in _taken)
        {
            context.DrawImage(
                _bitmap,
                rect.ToRect(1),
                new Rect(place.X + (rect.X * scaleX), place.Y + (rect.Y * scaleY), rect.Width * scaleX, rect.Height * scaleY));
        }
    }

    /// <summary>Releases the bitmap; the next call of <see cref="Take"/> creates a new one.</summary>
    public void LetGo()
    {
        _bitmap?.Dispose();
        (_bitmap, _taken) = (null, []);
    }
}
