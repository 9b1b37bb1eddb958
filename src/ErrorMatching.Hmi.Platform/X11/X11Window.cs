using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A window on the X server.</summary>
internal sealed unsafe class X11Window : PlatformWindow
{
    private readonly int _screen;
    private readonly X11Fingers _fingers;
    private nint _window;
    private X11SharedPixels? _shared;
    private bool _isShown;
    private PixelSize _normal;

    /// <summary>Creates a window that is not shown yet.</summary>
    /// <param name="scaling">Pixels per device-independent unit.</param>
    /// <param name="advise">Told once if something is missing without which windows open nevertheless.</param>
    /// <exception cref="PlatformNotSupportedException">There is no X server, or its screen has less than 24 bits.</exception>
    public X11Window(double scaling, Action<string>? advise = null)
        : base(scaling)
    {
        X11Connection.Open();
        _screen = Xlib.XDefaultScreen(X11Connection.Display);
        X11Picture.Demand(_screen);
        var size = Pixels;
        _window = Xlib.XCreateSimpleWindow(
            X11Connection.Display, Xlib.XRootWindow(X11Connection.Display, _screen), 0, 0, (uint)size.Width, (uint)size.Height, 0, 0, 0);
        _ = Xlib.XSelectInput(X11Connection.Display, _window, Xlib.EventMask);
        var protocol = X11Connection.DeleteWindow;
        _ = Xlib.XSetWMProtocols(X11Connection.Display, _window, &protocol, 1);
        _fingers = new(scaling, Touch);
        X11Connection.Add(_window, OnEvent, OnInput);
        X11Pointing.Select(_window, advise);
    }

    public override WindowState WindowState
    {
        get => base.WindowState;
        set
        {
            if (base.WindowState != value)
            {
                _normal = base.WindowState is WindowState.Normal ? Pixels : _normal;
                base.WindowState = value;
                X11WindowState.Ask(_window, _screen, value, ScreenSize, _normal);
                WindowStateChanged?.Invoke(value);
            }
        }
    }

    protected override PixelSize ScreenSize =>
        new(Xlib.XDisplayWidth(X11Connection.Display, _screen), Xlib.XDisplayHeight(X11Connection.Display, _screen));

    private PixelSize Pixels => PixelSize.FromSize(ClientSize, RenderScaling);

    public override void Show(bool activate, bool isDialog)
    {
        _isShown = true;
        _ = Xlib.XMapRaised(X11Connection.Display, _window);
        _ = Xlib.XFlush(X11Connection.Display);
        base.Show(activate, isDialog);
    }

    public override void Hide()
    {
        _fingers.Cancel();
        _ = Xlib.XUnmapWindow(X11Connection.Display, _window);
        _ = Xlib.XFlush(X11Connection.Display);
        base.Hide();
    }

    public override void SetTitle(string? title) => _ = Xlib.XStoreName(X11Connection.Display, _window, title ?? "");

    public override void SetCursor(ICursorImpl? cursor)
    {
        _ = Xlib.XDefineCursor(X11Connection.Display, _window, X11Cursors.Of((cursor as ShapeCursor)?.Shape ?? StandardCursorType.Arrow));
        _ = Xlib.XFlush(X11Connection.Display);
    }

    public override void SetMinMaxSize(Size minSize, Size maxSize)
    {
        // No window of the station has a largest size.
        var hints = new XSizeHints
        {
            Flags = XSizeHints.HasLeast,
            LeastWidth = Whole(minSize.Width),
            LeastHeight = Whole(minSize.Height),
        };
        Xlib.XSetWMNormalHints(X11Connection.Display, _window, ref hints);
        _ = Xlib.XFlush(X11Connection.Display);

        // Rounded up, as a smaller window would cut something off; but not because of the last digit of a product.
        int Whole(double units) => Math.Max(1, (int)Math.Ceiling((units * RenderScaling) - 1e-6));
    }

    public override void Resize(Size clientSize, WindowResizeReason reason = WindowResizeReason.Application)
    {
        var size = PixelSize.FromSize(clientSize, RenderScaling);
        if (size == Pixels || WindowState is WindowState.Maximized or WindowState.FullScreen)
        {
            return;
        }

        _ = Xlib.XResizeWindow(X11Connection.Display, _window, (uint)Math.Max(1, size.Width), (uint)Math.Max(1, size.Height));

        // Once it is on the screen, the server reports the resulting size: a requested and a reported size would keep triggering each
        // other.
        if (!_isShown)
        {
            base.Resize(clientSize, reason);
        }
    }

    public override void Dispose()
    {
        if (_window == 0)
        {
            return;
        }

        _fingers.Cancel();
        X11Connection.Remove(_window);
        _ = Xlib.XDestroyWindow(X11Connection.Display, _window);
        _ = Xlib.XFlush(X11Connection.Display);
        _window = 0;
        base.Dispose();
    }

    /// <summary>Handles an event.</summary>
    public void OnEvent(XEvent e)
    {
        var at = new Point(e.X, e.Y) / RenderScaling;
        var modifiers = X11Keys.Modifiers(e.State);
        switch (e.Type)
        {
            case Xlib.Expose:
                OnFrame(Frame is { } frame ? [new PixelRect(frame.PixelSize)] : []);
                break;
            case Xlib.ConfigureNotify:
                OnResized(new PixelSize(e.Width, e.Height).ToSize(RenderScaling), WindowResizeReason.User);
                break;
            case Xlib.MotionNotify:
                // While a button is held, or without XInput.
                Mouse(RawPointerEventType.Move, at, modifiers);
                break;
            case Xlib.LeaveNotify:
                Mouse(RawPointerEventType.LeaveWindow, at, modifiers);
                break;
            case Xlib.FocusIn:
                Activated?.Invoke();
                break;
            case Xlib.FocusOut:
                // Without a window manager the focus follows the pointer, and a finger may move out of the window as a held mouse may.
                if (e.FocusDetail != Xlib.FocusOfPointer)
                {
                    _fingers.Cancel();
                }

                LostFocus?.Invoke();
                Deactivated?.Invoke();
                break;
            case Xlib.ClientMessage when e.Data0 == X11Connection.DeleteWindow:
                if (Closing?.Invoke(WindowCloseReason.WindowClosing) != true)
                {
                    Dispose();
                }

                break;
            case Xlib.ButtonPress when e.Detail is >= 4 and <= 7:
                Wheel(
                    at,
                    e.Detail switch { 4 => new Vector(0, 1), 5 => new Vector(0, -1), 6 => new Vector(1, 0), _ => new Vector(-1, 0) },
                    modifiers);
                break;
            case Xlib.ButtonPress when e.Detail <= 3:
                Mouse(ButtonEvent(e.Detail, isDown: true), at, modifiers | X11Keys.Button(e.Detail));
                break;
            case Xlib.ButtonRelease when e.Detail <= 3:
                Mouse(ButtonEvent(e.Detail, isDown: false), at, modifiers & ~X11Keys.Button(e.Detail));
                break;
            case Xlib.KeyPress or Xlib.KeyRelease:
                OnKey(e, modifiers);
                break;
        }
    }

    /// <summary>Handles an event of the X Input Extension.</summary>
    public void OnInput(XInputEvent e)
    {
        if (e.Kind != XInput.Motion)
        {
            _fingers.On(e);
        }
        else if (!e.IsMarked)
        {
            Mouse(RawPointerEventType.Move, new Point(e.X, e.Y) / RenderScaling, X11Keys.Modifiers(e.State));
        }
    }

    protected override SkiaBitmap CreateFrame(PixelSize size, Vector dpi)
    {
        _shared = X11SharedPixels.Create(size);
        return _shared is { } shared ? new(size, dpi, shared.Address, shared.Dispose) : base.CreateFrame(size, dpi);
    }

    protected override void OnFrameBegins() => _shared?.Wait();

    protected override void OnFrame(IReadOnlyList<PixelRect> rects)
    {
        if (_window != 0 && Frame is { } frame)
        {
            X11Picture.Put(_window, _screen, frame, _shared, rects);
            X11Connection.DrainLater();
        }
    }

    private static RawPointerEventType ButtonEvent(uint button, bool isDown) => (button, isDown) switch
    {
        (1, true) => RawPointerEventType.LeftButtonDown,
        (1, false) => RawPointerEventType.LeftButtonUp,
        (2, true) => RawPointerEventType.MiddleButtonDown,
        (2, false) => RawPointerEventType.MiddleButtonUp,
        (_, true) => RawPointerEventType.RightButtonDown,
        _ => RawPointerEventType.RightButtonUp,
    };

    private void OnKey(XEvent e, RawInputModifiers modifiers)
    {
        var buffer = stackalloc byte[32];
        var length = Xlib.XLookupString(ref e, buffer, 32, out var keysym, 0);
        Key(e.Type == Xlib.KeyPress ? RawKeyEventType.KeyDown : RawKeyEventType.KeyUp, X11Keys.Of((uint)keysym), modifiers, (ulong)e.At);
        if (e.Type != Xlib.KeyPress
            || (modifiers & (RawInputModifiers.Control | RawInputModifiers.Alt | RawInputModifiers.Meta)) != RawInputModifiers.None)
        {
            return;
        }

        // Latin-1 comes from XLookupString, other characters from the keysyms that represent Unicode; input methods (XIM) are not
        // connected.
        var text = keysym >> 24 == 1 ? char.ConvertFromUtf32((int)(keysym & 0xFFFFFF)) : length == 1 ? ((char)buffer[0]).ToString() : "";
        if (text.Length > 0 && !char.IsControl(text[0]))
        {
            Text(text, (ulong)e.At);
        }
    }
}
