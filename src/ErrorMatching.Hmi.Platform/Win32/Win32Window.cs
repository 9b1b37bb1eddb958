using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Automation.Provider;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Input.TextInput;
using Avalonia.Platform;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A window on Windows.</summary>
internal sealed unsafe class Win32Window : PlatformWindow
{
    private const double UsualDpi = 96;
    private readonly double _scaling;
    private readonly Win32Settings _settings;
    private readonly Win32Frame _frame;
    private readonly Win32Mouse _mouse;
    private readonly Win32Pointing _pointing;
    private readonly Win32InputMethod _inputMethod;
    private Win32Pixels? _pixels;
    private Size _least;
    private nint _cursor = Win32Cursors.Of(StandardCursorType.Arrow);
    private bool _isShown, _isRead;
    private char _high;

    /// <summary>Creates a window that is not shown yet.</summary>
    /// <param name="scaling">Pixels per device-independent unit on a monitor that the system does not scale.</param>
    /// <param name="settings">What is told when the system's settings change.</param>
    /// <exception cref="PlatformNotSupportedException">The system refuses it.</exception>
    public Win32Window(double scaling, Win32Settings settings)
        : base(scaling)
    {
        (_scaling, _settings) = (scaling, settings);
        (_mouse, _pointing, _inputMethod) = (new(this), new(this), new(this));
        Window = Win32Class.Create(Win32Frame.Style, 0, On);
        _frame = new(Window);
        RenderScaling = Scaling(_frame.Dpi);
        OnResized(_frame.Inside.ToSize(RenderScaling), WindowResizeReason.Layout);
        _inputMethod.TurnOff();
    }

    /// <summary>When the current message was sent, in milliseconds. The system's own time has 32 bits and starts again after 50
    /// days.</summary>
    public static ulong TimeOfMessage
    {
        get
        {
            var now = Environment.TickCount64;
            return (ulong)(now - unchecked((uint)((int)now - User32.GetMessageTime())));
        }
    }

    /// <summary>The system's handle; 0 once it is closed.</summary>
    public nint Window { get; private set; }

    /// <summary>True if the latest input came from a finger, not from a mouse, a pen or a keyboard.</summary>
    public bool IsByFinger { get; private set; }

    public override WindowState WindowState
    {
        get => base.WindowState;
        set
        {
            var before = base.WindowState;
            if (before == value || Window == 0)
            {
                return;
            }

            base.WindowState = value;
            if (_isShown)
            {
                Apply();
            }

            WindowStateChanged?.Invoke(value);
        }
    }

    // What Avalonia shows in it.
    private Window? Top => Application.Current?.ApplicationLifetime is IClassicDesktopStyleApplicationLifetime desktop
        ? desktop.Windows.FirstOrDefault(w => ReferenceEquals(w.PlatformImpl, this))
        : null;

    protected override PixelSize ScreenSize => new(_frame.Monitor.Work.Width, _frame.Monitor.Work.Height);

    public override void Show(bool activate, bool isDialog)
    {
        // Only now: Avalonia has a size of its own in mind for a window that is not shown yet.
        _isShown = true;
        _settings.Follow();
        if (WindowState == WindowState.Normal && !activate)
        {
            _ = User32.ShowWindow(Window, User32.ShowNotActive);
        }
        else
        {
            Apply();
        }

        if (activate)
        {
            _ = User32.SetForegroundWindow(Window);
        }
    }

    public override void Hide()
    {
        _pointing.Cancel();
        _isShown = false;
        _ = User32.ShowWindow(Window, User32.Hide);
        base.Hide();
    }

    public override void Activate()
    {
        if (User32.IsIconic(Window) != 0)
        {
            _ = User32.ShowWindow(Window, Win32Frame.Showing(WindowState.Normal));
        }

        _ = User32.SetForegroundWindow(Window);
        base.Activate();
    }

    public override void SetTitle(string? title) => _ = User32.SetWindowText(Window, title ?? "");

    public override void SetFrameThemeVariant(PlatformThemeVariant? themeVariant)
    {
        // Where the system has no dark title bars, it refuses this, and nothing is lost.
        var isDark = themeVariant == PlatformThemeVariant.Dark ? 1 : 0;
        _ = Dwmapi.DwmSetWindowAttribute(Window, Dwmapi.DarkTitle, &isDark, sizeof(int));
    }

    public override void SetCursor(ICursorImpl? cursor)
    {
        _cursor = Win32Cursors.Of((cursor as ShapeCursor)?.Shape ?? StandardCursorType.Arrow);
        _ = User32.SetCursor(_cursor);
    }

    public override void SetMinMaxSize(Size minSize, Size maxSize) => _least = minSize;

    public override void Resize(Size clientSize, WindowResizeReason reason = WindowResizeReason.Application)
    {
        var size = PixelSize.FromSize(clientSize, RenderScaling);
        if (Window == 0 || size == _frame.Inside)
        {
            return;
        }

        if (WindowState is WindowState.Maximized or WindowState.FullScreen && _isShown)
        {
            // It stays as it is, which Avalonia has to know.
            Dispatcher.UIThread.Post(() => Resized?.Invoke(ClientSize, reason), DispatcherPriority.Send);
            return;
        }

        _frame.Resize(size);
    }

    public override object? TryGetFeature(Type featureType) =>
        featureType == typeof(ITextInputMethodImpl) ? _inputMethod : base.TryGetFeature(featureType);

    public override void Dispose()
    {
        if (Window == 0)
        {
            return;
        }

        _pointing.Cancel();
        _inputMethod.Close();
        var window = Window;
        if (_isRead)
        {
            // Nobody who reads the window shall ask it any more.
            _ = Uia.Return(window, 0, 0, null);
        }

        Window = 0;
        base.Dispose();
        _pixels = null;
        Win32Class.Destroy(window);
    }

    /// <summary>The place of a message's coordinates, in device-independent units.</summary>
    public Point At(nint l) => new Point((short)l, (short)(l >> 16)) / RenderScaling;

    /// <summary>The same for coordinates of the screen.</summary>
    public Point AtScreen(nint l)
    {
        var place = new User32.Pixel { X = (short)l, Y = (short)(l >> 16) };
        _ = User32.ScreenToClient(Window, &place);
        return new Point(place.X, place.Y) / RenderScaling;
    }

    protected override SkiaBitmap CreateFrame(PixelSize size, Vector dpi)
    {
        var pixels = new Win32Pixels(size);
        _pixels = pixels;
        return new(size, dpi, pixels.Address, pixels.Dispose);
    }

    protected override void OnFrameBegins() => Win32Pixels.Wait();

    protected override void OnFrame(IReadOnlyList<PixelRect> rects)
    {
        if (Window == 0 || _pixels is not { } pixels)
        {
            return;
        }

        var dc = User32.GetDC(Window);
        foreach (var rect in rects)
        {
            pixels.Put(dc, rect);
        }

        _ = User32.ReleaseDC(Window, dc);
    }

    // Handles a message; null leaves it to the system.
    private nint? On(uint message, nint w, nint l)
    {
        // The first messages come before the window is complete.
        if (Window == 0 || _frame is null)
        {
            return null;
        }

        IsByFinger = message switch
        {
            Win32Message.PointerDown => true,
            Win32Message.LeftDown or Win32Message.RightDown or Win32Message.KeyDown => false,
            _ => IsByFinger,
        };
        switch (message)
        {
            case Win32Message.SettingChanged or Win32Message.ColorsChanged:
                _settings.Follow();
                return null;
            case Win32Message.Paint:
                OnPaint();
                return 0;
            case Win32Message.EraseBackground:
                return 1;
            case Win32Message.Size:
                OnSize((int)w);
                return 0;
            case Win32Message.PlaceChanged:
                User32.Pixel corner = default;
                _ = User32.ClientToScreen(Window, &corner);
                Move(new(corner.X, corner.Y));
                return null;
            case Win32Message.GetLimits:
                var (width, height) = _frame.Outside(PixelSize.FromSize(_least, RenderScaling));
                ((User32.Limits*)l)->Least = new() { X = width, Y = height };
                return 0;
            case Win32Message.DpiChanged:
                OnDpi((uint)(w & 0xFFFF), *(User32.Rect*)l);
                return 0;
            case Win32Message.DisplayChanged when _frame.IsFull:
                _frame.Refill();
                return null;
            case Win32Message.GetObject when (int)l == Uia.Root && Uia.IsThere && Top is { } top:
                return OnRead(ControlAutomationPeer.CreatePeerForElement(top), w, l);
            case Win32Message.SetFocus:
                base.Activate();
                return 0;
            case Win32Message.KillFocus:
                _pointing.Cancel();
                LostFocus?.Invoke();
                Deactivated?.Invoke();
                return 0;
            case Win32Message.MenuBegins or Win32Message.MoveBegins:
                Win32Dispatcher.OnSystemsLoop(isRunning: true);
                return null;
            case Win32Message.MenuEnds or Win32Message.MoveEnds:
                Win32Dispatcher.OnSystemsLoop(isRunning: false);
                return null;
            case Win32Message.Close:
                Close(WindowCloseReason.WindowClosing);
                return 0;
            case Win32Message.SessionEnds when w != 0:
                // The system ends the program soon. What is being edited is stored already, so nobody is asked.
                Close(WindowCloseReason.OSShutdown);
                return 0;
            case Win32Message.SetCursor when (l & 0xFFFF) == 1:
                _ = User32.SetCursor(_cursor);
                return 1;
            case >= Win32Message.CompositionBegins and <= Win32Message.Composition or Win32Message.InputContext:
                return _inputMethod.On(message, w, l);
            case >= Win32Message.KeyDown and <= Win32Message.SystemChar or Win32Message.SystemCommand:
                return OnKey(message, w, l);
            default:
                return _mouse.On(message, w, l) || _pointing.On(message, w, l) ? 0 : null;
        }
    }

    // A screen reader, or another program that reads windows, asks what is in this one.
    private nint OnRead(AutomationPeer peer, nint w, nint l)
    {
        if (!_isRead && peer.GetProvider<IRootProvider>() is { } root)
        {
            _isRead = true;
            root.FocusChanged += (_, _) =>
            {
                if (Window != 0 && Uia.AreClientsListening() != 0 && Win32Element.Focused(root, this) is { } focused)
                {
                    _ = Uia.Raise(focused, Uia.FocusChanged);
                }
            };
        }

        return Uia.Return(Window, w, l, Win32Element.Of(peer, this));
    }

    private double Scaling(uint dpi) => _scaling * dpi / UsualDpi;

    private void Apply()
    {
        if (WindowState == WindowState.FullScreen)
        {
            // A maximized or minimized window has a size of its own in mind.
            if (!_frame.IsFull && _frame.IsVisible)
            {
                _ = User32.ShowWindow(Window, User32.ShowNormal);
            }

            _frame.Fill();
        }
        else if (_frame.IsFull && WindowState != WindowState.Minimized)
        {
            _frame.Unfill();
        }

        _ = User32.ShowWindow(Window, Win32Frame.Showing(WindowState));
    }

    private void Close(WindowCloseReason reason)
    {
        if (Closing?.Invoke(reason) != true)
        {
            Dispose();
        }
    }

    private void OnPaint()
    {
        User32.PaintArea paint;
        var dc = User32.BeginPaint(Window, &paint);
        _pixels?.Put(dc, new PixelRect(paint.Area.Left, paint.Area.Top, paint.Area.Width, paint.Area.Height).Intersect(new(_pixels.Size)));
        _ = User32.EndPaint(Window, &paint);
    }

    private void OnSize(int kind)
    {
        const int minimized = 1, maximized = 2;
        if (!_isShown)
        {
            return;
        }

        var state = kind switch
        {
            minimized => WindowState.Minimized,
            _ when _frame.IsFull => WindowState.FullScreen,
            maximized => WindowState.Maximized,
            _ => WindowState.Normal,
        };
        if (base.WindowState != state)
        {
            base.WindowState = state;
            WindowStateChanged?.Invoke(state);
        }

        if (kind != minimized)
        {
            OnResized(_frame.Inside.ToSize(RenderScaling), WindowResizeReason.User);
        }
    }

    private void OnDpi(uint dpi, User32.Rect to)
    {
        RenderScaling = Scaling(dpi);
        ScalingChanged?.Invoke(RenderScaling);
        if (_frame.IsFull)
        {
            _frame.Refill();
        }
        else
        {
            _frame.Put(to);
        }

        // Other units, even where the pixels are as many as before.
        OnResized(_frame.Inside.ToSize(RenderScaling), WindowResizeReason.DpiChange);
    }

    private nint? OnKey(uint message, nint w, nint l)
    {
        const nint menuByKey = 0xF100, withSpace = 0x20;
        switch (message)
        {
            case Win32Message.KeyDown or Win32Message.SystemKeyDown:
                Key(RawKeyEventType.KeyDown, Win32Keys.Of((int)w, l), Win32Keys.Held, TimeOfMessage);
                return message == Win32Message.KeyDown ? 0 : null;
            case Win32Message.KeyUp or Win32Message.SystemKeyUp:
                Key(RawKeyEventType.KeyUp, Win32Keys.Of((int)w, l), Win32Keys.Held, TimeOfMessage);
                return message == Win32Message.KeyUp ? 0 : null;
            case Win32Message.Char:
                OnCharacter((char)w);
                return 0;
            case Win32Message.SystemChar when w != withSpace:
                // The system would look for a menu that the window does not have, and beep.
                return 0;
            case Win32Message.SystemCommand when (w & 0xFFF0) == menuByKey && l == 0:
                // Alt or F10 alone would open the system's menu, which takes the next key.
                return 0;
            default:
                return null;
        }
    }

    private void OnCharacter(char c)
    {
        if (char.IsHighSurrogate(c))
        {
            _high = c;
        }
        else if (char.IsLowSurrogate(c))
        {
            Text(new string([_high, c]), TimeOfMessage);
        }
        else if (!char.IsControl(c))
        {
            Text(c.ToString(), TimeOfMessage);
        }
    }
}
