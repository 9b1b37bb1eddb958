using System.Diagnostics;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The common part of windows on each system and off screen: size, frame, input. The members of Avalonia's interface that need
/// no code here are in the other file.</summary>
internal abstract partial class PlatformWindow : IWindowImpl
{
    private static int _lastZOrder;
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly IKeyboardDevice _keyboard = AvaloniaLocator.Current.GetRequiredService<IKeyboardDevice>();
    private readonly MouseDevice _mouse = new(new Pointer(Pointer.GetNextFreeId(), PointerType.Mouse, isPrimary: true));
    private readonly TouchDevice _touch = new();
    private readonly FrameSurface _surface;
    private readonly Lazy<OneScreen> _screens;
    private IInputRoot? _root;

    /// <summary>Creates a window that is not shown yet.</summary>
    /// <param name="scaling">Pixels per device-independent unit.</param>
    protected PlatformWindow(double scaling)
    {
        RenderScaling = scaling;
        _surface = new() { Create = CreateFrame, Begins = OnFrameBegins, Drawn = OnFrame };
        Surfaces = [_surface];
        _screens = new(() => new OneScreen(ScreenSize, RenderScaling));
    }

    /// <summary>The last frame; null before the first one.</summary>
    public SkiaBitmap? Frame => _surface.Frame;

    /// <summary>Stacking order: the most recently activated window has the largest.</summary>
    public int ZOrder { get; private set; }

    public Size ClientSize { get; private set; } = new(1280, 800);

    public double RenderScaling { get; protected set; }

    public double DesktopScaling => RenderScaling;

    /// <summary>Pixels of the screen.</summary>
    protected virtual PixelSize ScreenSize => new(3840, 2160);

    private ulong Now => (ulong)_clock.ElapsedMilliseconds;

    /// <summary>Passes on a pointer event, at a position in device-independent units.</summary>
    public void Mouse(RawPointerEventType type, Point at, RawInputModifiers modifiers) =>
        Input?.Invoke(new RawPointerEventArgs(_mouse, Now, _root!, type, at, modifiers));

    /// <summary>Passes on a touch event.</summary>
    public void Touch(RawPointerEventType type, Point at, long finger = 1) =>
        Input?.Invoke(new RawTouchEventArgs(_touch, Now, _root!, type, at, RawInputModifiers.None, finger));

    /// <summary>Passes on a wheel event.</summary>
    public void Wheel(Point at, Vector delta, RawInputModifiers modifiers) =>
        Input?.Invoke(new RawMouseWheelEventArgs(_mouse, Now, _root!, at, delta, modifiers));

    /// <summary>Passes on a key event.</summary>
    /// <param name="type">Down or up.</param>
    /// <param name="key">The key.</param>
    /// <param name="modifiers">The modifiers.</param>
    /// <param name="at">When the key was pressed, in milliseconds. That is earlier than now if the station was busy.</param>
    public void Key(RawKeyEventType type, Key key, RawInputModifiers modifiers, ulong at) =>
        Input?.Invoke(new RawKeyEventArgs(_keyboard, at, _root!, type, key, modifiers, PhysicalKey.None, null, KeyDeviceType.Keyboard));

    /// <summary>Passes on typed text.</summary>
    /// <param name="text">The text.</param>
    /// <param name="at">When it was typed, on the same clock as keys.</param>
    public void Text(string text, ulong at) => Input?.Invoke(new RawTextInputEventArgs(_keyboard, at, _root!, text));

    public void SetInputRoot(IInputRoot inputRoot) => _root = inputRoot;

    public Point PointToClient(PixelPoint point) => (point - Position).ToPoint(RenderScaling);

    public PixelPoint PointToScreen(Point point) => PixelPoint.FromPoint(point, RenderScaling) + Position;

    public virtual object? TryGetFeature(Type featureType) =>
        featureType == typeof(IScreenImpl) ? _screens.Value
        : featureType == typeof(Avalonia.Input.Platform.IClipboard) ? AvaloniaLocator.Current.GetService(featureType)
        : null;

    public virtual void Resize(Size clientSize, WindowResizeReason reason = WindowResizeReason.Application) =>
        Dispatcher.UIThread.Post(() => OnResized(clientSize, reason), DispatcherPriority.Send);

    public virtual void Show(bool activate, bool isDialog)
    {
        if (activate)
        {
            Activate();
        }
    }

    public virtual void Hide() => Dispatcher.UIThread.Post(() => Deactivated?.Invoke(), DispatcherPriority.Input);

    public virtual void Activate()
    {
        ZOrder = ++_lastZOrder;
        Dispatcher.UIThread.Post(() => Activated?.Invoke(), DispatcherPriority.Input);
    }

    public void Move(PixelPoint point)
    {
        Position = point;
        PositionChanged?.Invoke(point);
    }

    public virtual void Dispose()
    {
        Closed?.Invoke();
        _mouse.Dispose();
        _touch.Dispose();
        _surface.Frame?.Dispose();
        _surface.Frame = null;
    }

    /// <summary>Creates the picture that frames of a size are drawn in.</summary>
    protected virtual SkiaBitmap CreateFrame(PixelSize size, Vector dpi) => new(size, dpi);

    /// <summary>Called before a frame is drawn over the previous one.</summary>
    protected virtual void OnFrameBegins()
    {
        // Off screen, nobody else looks at the previous one.
    }

    /// <summary>Called when a frame is complete in <see cref="Frame"/>.</summary>
    /// <param name="rects">What has changed in it, in pixels.</param>
    protected virtual void OnFrame(IReadOnlyList<PixelRect> rects)
    {
        // Off screen, the frame is just kept.
    }

    /// <summary>Call when the window's size has changed, in device-independent units.</summary>
    protected void OnResized(Size clientSize, WindowResizeReason reason)
    {
        if (ClientSize != clientSize)
        {
            ClientSize = clientSize;
            Resized?.Invoke(clientSize, reason);
        }
    }
}
