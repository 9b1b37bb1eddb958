using System.Diagnostics;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>What windows off the screen and on X11 have in common: size, frame, input. The other half of Avalonia's interface, which needs nothing here, is in the other file.</summary>
internal abstract partial class PlatformWindow : IWindowImpl
{
    private static int _lastZOrder;
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly IKeyboardDevice _keyboard = AvaloniaLocator.Current.GetRequiredService<IKeyboardDevice>();
    private readonly MouseDevice _mouse = new(new Pointer(Pointer.GetNextFreeId(), PointerType.Mouse, isPrimary: true));
    private readonly TouchDevice _touch = new();
    private readonly FrameSurface _surface = new();
    private readonly Lazy<OneScreen> _screens;
    private IInputRoot? _root;

    /// <summary>A window that is not shown yet.</summary>
    /// <param name="scaling">Pixels a device-independent unit.</param>
    protected PlatformWindow(double scaling)
    {
        RenderScaling = scaling;
        _surface.Drawn = OnFrame;
        Surfaces = [_surface];
        _screens = new(() => new OneScreen(ScreenSize, scaling));
    }

    /// <summary>The last frame; null before the first one.</summary>
    public CairoBitmap? Frame => _surface.Frame;

    /// <summary>The window that was activated last has the largest.</summary>
    public int ZOrder { get; private set; }

    /// <inheritdoc/>
    public Size ClientSize { get; private set; } = new(1280, 800);

    /// <inheritdoc/>
    public double RenderScaling { get; }

    /// <inheritdoc/>
    public double DesktopScaling => RenderScaling;

    /// <summary>Pixels of the screen.</summary>
    protected virtual PixelSize ScreenSize => new(3840, 2160);

    private ulong Now => (ulong)_clock.ElapsedMilliseconds;

    /// <summary>Passes on what a pointer did, at a place in device-independent units.</summary>
    public void Mouse(RawPointerEventType type, Point at, RawInputModifiers modifiers) => Input?.Invoke(new RawPointerEventArgs(_mouse, Now, _root!, type, at, modifiers));

    /// <summary>Passes on what a finger did.</summary>
    public void Touch(RawPointerEventType type, Point at, long finger = 1) => Input?.Invoke(new RawTouchEventArgs(_touch, Now, _root!, type, at, RawInputModifiers.None, finger));

    /// <summary>Passes on what a wheel did.</summary>
    public void Wheel(Point at, Vector delta, RawInputModifiers modifiers) => Input?.Invoke(new RawMouseWheelEventArgs(_mouse, Now, _root!, at, delta, modifiers));

    /// <summary>Passes on what a key did.</summary>
    public void Key(RawKeyEventType type, Key key, RawInputModifiers modifiers) =>
        Input?.Invoke(new RawKeyEventArgs(_keyboard, Now, _root!, type, key, modifiers, PhysicalKey.None, null, KeyDeviceType.Keyboard));

    /// <summary>Passes on text that was typed.</summary>
    public void Text(string text) => Input?.Invoke(new RawTextInputEventArgs(_keyboard, Now, _root!, text));

    /// <inheritdoc/>
    public void SetInputRoot(IInputRoot inputRoot) => _root = inputRoot;

    /// <inheritdoc/>
    public Point PointToClient(PixelPoint point) => (point - Position).ToPoint(RenderScaling);

    /// <inheritdoc/>
    public PixelPoint PointToScreen(Point point) => PixelPoint.FromPoint(point, RenderScaling) + Position;

    /// <inheritdoc/>
    public object? TryGetFeature(Type featureType) =>
        featureType == typeof(IScreenImpl) ? _screens.Value
        : featureType == typeof(Avalonia.Input.Platform.IClipboard) ? AvaloniaLocator.Current.GetService(featureType)
        : null;

    /// <inheritdoc/>
    public virtual void Resize(Size clientSize, WindowResizeReason reason = WindowResizeReason.Application) => Dispatcher.UIThread.Post(() => OnResized(clientSize, reason), DispatcherPriority.Send);

    /// <inheritdoc/>
    public virtual void Show(bool activate, bool isDialog)
    {
        if (activate)
        {
            Activate();
        }
    }

    /// <inheritdoc/>
    public virtual void Hide() => Dispatcher.UIThread.Post(() => Deactivated?.Invoke(), DispatcherPriority.Input);

    /// <inheritdoc/>
    public void Activate()
    {
        ZOrder = ++_lastZOrder;
        Dispatcher.UIThread.Post(() => Activated?.Invoke(), DispatcherPriority.Input);
    }

    /// <inheritdoc/>
    public void Move(PixelPoint point)
    {
        Position = point;
        PositionChanged?.Invoke(point);
    }

    /// <inheritdoc/>
    public virtual void Dispose()
    {
        Closed?.Invoke();
        _mouse.Dispose();
        _touch.Dispose();
        _surface.Frame?.Dispose();
        _surface.Frame = null;
    }

    /// <summary>Called when a frame is complete in <see cref="Frame"/>.</summary>
    protected virtual void OnFrame()
    {
        // Off the screen, a frame just stays there.
    }

    /// <summary>Called when the window has another size, in device-independent units.</summary>
    protected void OnResized(Size clientSize, WindowResizeReason reason)
    {
        if (ClientSize != clientSize)
        {
            ClientSize = clientSize;
            Resized?.Invoke(clientSize, reason);
        }
    }
}
