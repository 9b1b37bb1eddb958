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
            surface.Frame = new CairoBitmap(sceneInfo.Size, new Vector(96, 96) * sceneInfo.Scaling);
        }
        properties = new RenderTargetDrawingContextProperties { PreviousFrameIsRetained = keep };
        return new CairoContext(surface.Frame!, 1) { Finished = surface.Drawn };
    }

    public void Dispose() { }
}
