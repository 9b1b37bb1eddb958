using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>No window icons: on Linux the desktop entry names one, on Windows it is in the program.</summary>
internal sealed class NoIcons : IPlatformIconLoader
{
    public IWindowIconImpl LoadIcon(string fileName) => new NoIcon();

    public IWindowIconImpl LoadIcon(Stream stream) => new NoIcon();

    public IWindowIconImpl LoadIcon(IBitmapImpl bitmap) => new NoIcon();

    private sealed class NoIcon : IWindowIconImpl
    {
        public void Save(Stream outputStream)
        {
            // There is nothing to save.
        }
    }
}
