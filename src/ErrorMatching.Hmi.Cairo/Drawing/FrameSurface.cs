using Avalonia.Platform.Surfaces;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>Where a window's frames go: the last frame stays here for screenshots (and is what an X11 window would show).</summary>
internal sealed class FrameSurface : IPlatformRenderSurface
{
    public CairoBitmap? Frame { get; set; }
    public Action? Drawn { get; set; }
}
