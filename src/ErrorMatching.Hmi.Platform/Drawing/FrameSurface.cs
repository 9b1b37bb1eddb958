using Avalonia.Platform.Surfaces;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Receives a window's frames. The last one is kept for screenshots; an X11 window displays the same frame.</summary>
internal sealed class FrameSurface : IPlatformRenderSurface
{
    public CairoBitmap? Frame { get; set; }
    public Action? Drawn { get; set; }
}
