using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace ErrorMatching.Hmi;

/// <summary>A canvas of pixels that is shown as a picture: what a drawing has too many lines or dots for to draw them as shapes.</summary>
internal sealed class PixelLayer : IDisposable
{
    private WriteableBitmap? _bitmap;

    /// <summary>The pixels.</summary>
    public PixelCanvas Canvas { get; } = new();

    /// <summary>A color of one kind as a pixel of the canvas; nothing for other brushes.</summary>
    public static int ColorOf(IBrush? brush) => brush is ISolidColorBrush { Color: var c } ? unchecked((int)((0xFFu << 24) | ((uint)c.R << 16) | ((uint)c.G << 8) | c.B)) : 0;

    /// <summary>Takes what is painted on the canvas over into the picture.</summary>
    public void Take()
    {
        var size = new PixelSize(Canvas.Width, Canvas.Height);
        if (_bitmap?.PixelSize != size)
        {
            _bitmap?.Dispose();
            _bitmap = new(size, new(96, 96), PixelFormat.Bgra8888, AlphaFormat.Premul);
        }

        using var locked = _bitmap.Lock();
        for (var row = 0; row < size.Height; row++)
        {
            Marshal.Copy(Canvas.Memory, row * size.Width, locked.Address + (row * locked.RowBytes), size.Width);
        }
    }

    /// <summary>Shows the picture.</summary>
    /// <param name="context">Where.</param>
    /// <param name="place">Its left upper corner and size in units of the screen.</param>
    public void Show(DrawingContext context, Rect place)
    {
        if (_bitmap is not null)
        {
            using var options = context.PushRenderOptions(new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None });
            context.DrawImage(_bitmap, new Rect(_bitmap.PixelSize.ToSize(1)), place);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _bitmap?.Dispose();
        _bitmap = null;
    }
}
