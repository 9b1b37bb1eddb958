using Avalonia;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

internal sealed class FrameRenderTarget(FrameSurface surface) : IRenderTarget
{
    public RenderTargetProperties Properties => new() { RetainsPreviousFrameContents = true, IsSuitableForDirectRendering = true };

    public IDrawingContextImpl CreateDrawingContext(
        IRenderTarget.RenderTargetSceneInfo sceneInfo, out RenderTargetDrawingContextProperties properties)
    {
        var keep = surface.Frame?.PixelSize == sceneInfo.Size;
        if (!keep)
        {
            surface.Frame?.Dispose();
            surface.Frame = surface.Create(sceneInfo.Size, new Vector(96, 96) * sceneInfo.Scaling);
        }

        properties = new RenderTargetDrawingContextProperties { PreviousFrameIsRetained = keep };
        var damage = new Damage(sceneInfo.Size);
        surface.Begins();
        return surface.Frame!.Draw(1, damage, () => surface.Drawn(damage.Rects));
    }

    public void Dispose()
    {
        // The window owns its frame.
    }
}
