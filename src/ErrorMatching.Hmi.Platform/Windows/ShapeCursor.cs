using Avalonia.Input;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

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
