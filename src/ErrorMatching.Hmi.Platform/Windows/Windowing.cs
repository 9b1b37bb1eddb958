using Avalonia;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Platform;
using Avalonia.Rendering;
using Avalonia.Rendering.Composition;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Creates windows for Avalonia, and holds what windows share.</summary>
internal sealed class Windowing(Func<PlatformWindow> create) : IWindowingPlatform
{
    /// <summary>Composes frames.</summary>
    public static Compositor Compositor { get; private set; } = null!;

    /// <summary>Registers the platform's services, on the thread that becomes the UI thread.</summary>
    /// <param name="timer">The clock of frames.</param>
    /// <param name="create">Creates a window.</param>
    /// <param name="clipboard">The clipboard.</param>
    /// <param name="dispatcher">The loop of the UI thread; null for one that waits for nothing but its own work.</param>
    /// <param name="settings">What a person chose for the whole system; null for Avalonia's own values.</param>
    public static void Initialize(
        IRenderTimer timer,
        Func<PlatformWindow> create,
        IClipboard clipboard,
        IDispatcherImpl? dispatcher = null,
        IPlatformSettings? settings = null)
    {
        Dispatcher.InitializeUIThreadDispatcher(dispatcher ?? new ManagedDispatcherImpl(null));
        AvaloniaLocator.CurrentMutable
            .Bind<IWindowingPlatform>().ToConstant(new Windowing(create))
            .Bind<IRenderLoop>().ToConstant(RenderLoop.FromTimer(timer))
            .Bind<IKeyboardDevice>().ToConstant(new KeyboardDevice())
            .Bind<IClipboard>().ToConstant(clipboard)
            .Bind<ICursorFactory>().ToConstant(new ShapeCursors())
            .Bind<IPlatformIconLoader>().ToConstant(new NoIcons())
            .Bind<IPlatformSettings>().ToConstant(settings ?? new DefaultPlatformSettings())
            .Bind<PlatformHotkeyConfiguration>().ToConstant(new PlatformHotkeyConfiguration())
            .Bind<KeyGestureFormatInfo>().ToConstant(new KeyGestureFormatInfo(
                new Dictionary<Key, string>(), "Meta", "Ctrl", "Alt", "Shift"));
        Compositor = new Compositor(null);
    }

    public IWindowImpl CreateWindow() => create();

    public ITopLevelImpl CreateEmbeddableTopLevel() => create();

    public IWindowImpl CreateEmbeddableWindow() =>
        throw new PlatformNotSupportedException("Windows inside foreign windows are not supported.");

    public ITrayIconImpl? CreateTrayIcon() => null;

    public void GetWindowsZOrder(ReadOnlySpan<IWindowImpl> windows, Span<long> zOrder)
    {
        for (var i = 0; i < windows.Length; i++)
        {
            zOrder[i] = (windows[i] as PlatformWindow)?.ZOrder ?? 0;
        }
    }
}

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
