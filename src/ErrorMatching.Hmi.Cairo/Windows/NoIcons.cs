using Avalonia.Platform;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>Window icons, which nobody sees on a station that fills its screen.</summary>
internal sealed class NoIcons : IPlatformIconLoader
{
    /// <inheritdoc/>
    public IWindowIconImpl LoadIcon(string fileName) => new NoIcon();

    /// <inheritdoc/>
    public IWindowIconImpl LoadIcon(Stream stream) => new NoIcon();

    /// <inheritdoc/>
    public IWindowIconImpl LoadIcon(IBitmapImpl bitmap) => new NoIcon();

    private sealed class NoIcon : IWindowIconImpl
    {
        public void Save(Stream outputStream)
        {
            // There is nothing to save.
        }
    }
}
