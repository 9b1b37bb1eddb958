using Avalonia.Input;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>A cursor by the name of its shape.</summary>
internal sealed class ShapeCursor(StandardCursorType shape) : ICursorImpl
{
    /// <summary>The shape.</summary>
    public StandardCursorType Shape { get; } = shape;

    /// <inheritdoc/>
    public void Dispose()
    {
        // Nothing native stands behind it.
    }
}
