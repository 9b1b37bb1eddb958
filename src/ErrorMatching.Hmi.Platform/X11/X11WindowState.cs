using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Asks the window manager for a window state (EWMH, _NET_WM_STATE). Without a window manager, as on a station that shows nothing
/// else, it gives the window the whole screen.</summary>
internal static unsafe class X11WindowState
{
    private const int Remove = 0, Add = 1;
    private const nint Atoms = 4;

    /// <summary>Requests a state.</summary>
    /// <param name="window">The window.</param>
    /// <param name="screenNumber">Its screen.</param>
    /// <param name="state">The state.</param>
    /// <param name="screen">Size of the screen in pixels.</param>
    /// <param name="normal">Size of the window in pixels when it does not fill the screen.</param>
    public static void Ask(nint window, int screenNumber, WindowState state, PixelSize screen, PixelSize normal)
    {
        var display = X11Connection.Display;
        if (state == WindowState.Minimized)
        {
            _ = Xlib.XIconifyWindow(display, window, screenNumber);
        }
        else
        {
            var (full, wide, high) = (
                Atom("_NET_WM_STATE_FULLSCREEN"), Atom("_NET_WM_STATE_MAXIMIZED_HORZ"), Atom("_NET_WM_STATE_MAXIMIZED_VERT"));
            Keep(window, state switch { WindowState.FullScreen => [full], WindowState.Maximized => [wide, high], _ => [] });
            Tell(window, screenNumber, state == WindowState.FullScreen ? Add : Remove, full, 0);
            Tell(window, screenNumber, state == WindowState.Maximized ? Add : Remove, wide, high);
            var size = state == WindowState.Normal ? normal : screen;
            _ = Xlib.XMoveResizeWindow(display, window, 0, 0, (uint)size.Width, (uint)size.Height);
        }

        _ = Xlib.XFlush(display);
    }

    // The window manager reads it when the window is mapped.
    private static void Keep(nint window, nint[] atoms)
    {
        fixed (nint* data = atoms)
        {
            if (atoms.Length == 0)
            {
                _ = Xlib.XDeleteProperty(X11Connection.Display, window, Atom("_NET_WM_STATE"));
            }
            else
            {
                _ = Xlib.XChangeProperty(X11Connection.Display, window, Atom("_NET_WM_STATE"), Atoms, 32, 0, data, atoms.Length);
            }
        }
    }

    // Has an effect while the window is mapped.
    private static void Tell(nint window, int screenNumber, int act, nint first, nint second)
    {
        var message = new XEvent
        {
            Type = Xlib.ClientMessage,
            Window = window,
            MessageType = Atom("_NET_WM_STATE"),
            Format = 32,
            Data0 = act,
            Data1 = first,
            Data2 = second
        };
        _ = Xlib.XSendEvent(
            X11Connection.Display, Xlib.XRootWindow(X11Connection.Display, screenNumber), 0, Xlib.SubstructureMask, ref message);
    }

    private static nint Atom(string name) => Xlib.XInternAtom(X11Connection.Display, name, 0);
}
