using Avalonia;
using Avalonia.Platform.Surfaces;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Receives a window's frames. The last one is kept for screenshots; a window displays the same frame.</summary>
internal sealed class FrameSurface : IPlatformRenderSurface
{
    /// <summary>The last frame.</summary>
    public SkiaBitmap? Frame { get; set; }

    /// <summary>Creates the picture that frames of a size are drawn in.</summary>
    public required Func<PixelSize, Vector, SkiaBitmap> Create { get; init; }

    /// <summary>Called before each frame.</summary>
    public required Action Begins { get; init; }

    /// <summary>Called after each frame with the rectangles that were drawn on.</summary>
    public required Action<IReadOnlyList<PixelRect>> Drawn { get; init; }
}
