using System.Runtime.InteropServices;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The single connection to the X server, used only on the UI thread.</summary>
/// <remarks>A second thread only waits for the socket: a thread blocked in XNextEvent, with XInitThreads, would delay the drawing thread's
/// round trips until the next event.</remarks>
internal static class X11Connection
{
    private static readonly Dictionary<nint, (Action<XEvent> OnEvent, Action<XInputEvent>? OnInput)> Windows = [];
    private const int ErrorCode = 32, BadWindow = 3;
    private static bool _isTrying, _isRefused;
    private static unsafe delegate* unmanaged[Cdecl]<nint, byte*, int> _otherwise;
    private static readonly AutoResetEvent Drained = new(false);

    /// <summary>The display; 0 before <see cref="Open"/>.</summary>
    public static nint Display { get; private set; }

    /// <summary>The message with which a window manager asks a window to close.</summary>
    public static nint DeleteWindow { get; private set; }

    /// <summary>Registers a window's event handlers.</summary>
    public static void Add(nint window, Action<XEvent> onEvent, Action<XInputEvent>? onInput = null) =>
        Windows[window] = (onEvent, onInput);

    /// <summary>Removes a window's event handlers.</summary>
    public static void Remove(nint window) => Windows.Remove(window);

    /// <summary>Connects, once.</summary>
    /// <param name="name">The display; null for that of <c>DISPLAY</c>.</param>
    /// <exception cref="PlatformNotSupportedException">There is no X server.</exception>
    public static unsafe void Open(string? name = null)
    {
        if (Display != 0)
        {
            return;
        }

        Display = Xlib.XOpenDisplay(name);
        if (Display == 0)
        {
            throw new PlatformNotSupportedException(
                "No X server answers: DISPLAY is not set, or names one that is not there. The operator station needs a screen.");
        }

        _otherwise = Xlib.XSetErrorHandler(&OnError);
        DeleteWindow = Xlib.XInternAtom(Display, "WM_DELETE_WINDOW", 0);
        var (ui, socket) = (Dispatcher.UIThread, Xlib.XConnectionNumber(Display));
        new Thread(() => Watch(ui, socket)) { IsBackground = true, Name = "X11 socket" }.Start();
    }

    /// <summary>Must be called after requests with replies: events may have been read along with a reply, and the socket does not signal
    /// those.</summary>
    public static void DrainLater()
    {
        _ = Xlib.XFlush(Display);
        if (Xlib.XEventsQueued(Display, 0) > 0)
        {
            Dispatcher.UIThread.Post(Drain, DispatcherPriority.Input);
        }
    }

    /// <summary>Sends requests that the server may refuse, and waits for its verdict.</summary>
    /// <returns>False if it refused one of them.</returns>
    public static bool Accepts(Action requests)
    {
        // Errors of earlier requests are not meant.
        _ = Xlib.XSync(Display, 0);
        (_isTrying, _isRefused) = (true, false);
        requests();
        _ = Xlib.XSync(Display, 0);
        _isTrying = false;
        DrainLater();
        return !_isRefused;
    }

    // A program that requested the clipboard may have ended before the response. All other errors of the server go to Xlib, which reports
    // them and ends the program.
    [UnmanagedCallersOnly(CallConvs = [typeof(System.Runtime.CompilerServices.CallConvCdecl)])]
    private static unsafe int OnError(nint display, byte* error)
    {
        _isRefused |= _isTrying;
        return _isTrying || error[ErrorCode] == BadWindow ? 0 : _otherwise(display, error);
    }

    private static void Watch(Dispatcher ui, int socket)
    {
        while (true)
        {
            var wait = new PollFd { Fd = socket, Events = 1 };
            if (Xlib.poll(ref wait, 1, -1) < 0)
            {
                // Interrupted.
                continue;
            }

            ui.Post(
                () =>
                {
                    Drain();
                    Drained.Set();
                },
                DispatcherPriority.Input);
            Drained.WaitOne();
        }
    }

    private static void Drain()
    {
        while (Xlib.XPending(Display) > 0)
        {
            _ = Xlib.XNextEvent(Display, out var e);
            if (e.Type == Xlib.GenericEvent)
            {
                if (X11Pointing.Read(ref e) is { } input && Windows.TryGetValue(input.Window, out var target))
                {
                    target.OnInput?.Invoke(input);
                }
            }
            else if (Windows.TryGetValue(e.Window, out var window))
            {
                window.OnEvent(e);
            }
        }
    }
}
