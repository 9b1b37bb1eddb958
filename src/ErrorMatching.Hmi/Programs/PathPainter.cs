using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Paints a path pixel by pixel in the background, and shows the last painting at its current place until the next is
/// ready.</summary>
/// <param name="invalidate">Called when a new painting can be shown.</param>
internal sealed class PathPainter(Action invalidate)
{
    private readonly PixelLayer _layer = new();
    private PathFrame? _wanted, _painting, _painted;
    private bool _isSeen;

    /// <summary>The current background painting, or the last one.</summary>
    public Task Painting { get; private set; } = Task.CompletedTask;

    /// <summary>Starts when the plot appears on the screen.</summary>
    public void Begin() => _isSeen = true;

    /// <summary>Releases the bitmap when the plot leaves the screen.</summary>
    public void End()
    {
        _isSeen = false;
        _layer.LetGo();
        _painted = null;
    }

    /// <summary>Shows the last painting, moved to where it belongs in a frame, and paints the frame unless that is done.</summary>
    public void Show(DrawingContext context, PathFrame frame)
    {
        if (frame != (_painting ?? _painted))
        {
            _wanted = frame;
            if (_painting is null)
            {
                Painting = PaintAsync().Watched();
            }
        }

        if (_painted is not { } painted || painted.Program != frame.Program)
        {
            return;
        }

        var (corner, scale) = (frame.View.At(painted.View.ToPlot(new(0, 0))), frame.View.ScaleX / painted.View.ScaleX);

        // A bitmap aligned to whole pixels is copied, which takes a tenth of the time.
        corner = scale == 1
            ? new Point(Math.Round(corner.X / frame.Pixel) * frame.Pixel, Math.Round(corner.Y / frame.Pixel) * frame.Pixel)
            : corner;
        _layer.Show(context, new Rect(corner, new Size(painted.Width * painted.Pixel * scale, painted.Height * painted.Pixel * scale)));
    }

    private async Task PaintAsync()
    {
        while (_wanted is { } frame)
        {
            (_wanted, _painting) = (null, frame);

            // Starts while a frame is drawn, when no redraw may be requested; so the continuation is always posted.
            await Task.Run(() => frame.Paint(_layer.Canvas)).ConfigureAwait(
                ConfigureAwaitOptions.ForceYielding | ConfigureAwaitOptions.ContinueOnCapturedContext);
            _painting = null;
            if (!_isSeen)
            {
                return;
            }

            _layer.Take();
            _painted = frame;
            invalidate();
        }
    }
}
