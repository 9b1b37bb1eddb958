using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The size and place of one window: what the system puts around it, and its states.</summary>
/// <param name="window">The window.</param>
internal sealed unsafe class Win32Frame(nint window)
{
    private const uint Normal = User32.Overlapped | User32.ClipChildren, Nearest = 2;
    private User32.Rect _before;

    /// <summary>The style of a window that does not fill the screen.</summary>
    public static uint Style => Normal;

    /// <summary>True if it fills the whole monitor, without a frame. It can be minimized meanwhile.</summary>
    public bool IsFull { get; private set; }

    /// <summary>True if it is shown, even if it is minimized.</summary>
    public bool IsVisible => User32.IsWindowVisible(window) != 0;

    /// <summary>Pixels per inch of the monitor that the window is on.</summary>
    public uint Dpi => User32.GetDpiForWindow(window);

    /// <summary>Pixels inside.</summary>
    public PixelSize Inside
    {
        get
        {
            User32.Rect rect;
            _ = User32.GetClientRect(window, &rect);
            return new(Math.Max(1, rect.Width), Math.Max(1, rect.Height));
        }
    }

    /// <summary>The monitor that the window is on, or next to.</summary>
    public User32.Monitor Monitor
    {
        get
        {
            var info = new User32.Monitor { Bytes = sizeof(User32.Monitor) };
            _ = User32.GetMonitorInfo(User32.MonitorFromWindow(window, Nearest), &info);
            return info;
        }
    }

    /// <summary>How <see cref="User32.ShowWindow"/> shows a state.</summary>
    public static int Showing(WindowState state) => state switch
    {
        WindowState.FullScreen => User32.ShowAsIs,
        WindowState.Maximized => User32.ShowMaximized,
        WindowState.Minimized => User32.ShowMinimized,
        _ => User32.ShowNormal,
    };

    /// <summary>The size of a window with so many pixels inside.</summary>
    public (int Width, int Height) Outside(PixelSize inside)
    {
        var rect = new User32.Rect { Right = inside.Width, Bottom = inside.Height };
        _ = User32.AdjustWindowRectExForDpi(&rect, Normal, 0, 0, Dpi);
        return (rect.Width, rect.Height);
    }

    /// <summary>Gives the window so many pixels inside.</summary>
    public void Resize(PixelSize inside)
    {
        var (width, height) = Outside(inside);
        _ = User32.SetWindowPos(window, 0, 0, 0, width, height, User32.KeepPlace | User32.KeepOrder | User32.NotActive);
    }

    /// <summary>Puts the window into a rectangle of the screen.</summary>
    public void Put(User32.Rect to, uint flags = 0) => _ = User32.SetWindowPos(
        window, 0, to.Left, to.Top, to.Width, to.Height, User32.KeepOrder | User32.NotActive | flags);

    /// <summary>Fills the whole monitor, without a frame.</summary>
    public void Fill()
    {
        if (!IsFull)
        {
            fixed (User32.Rect* before = &_before)
            {
                _ = User32.GetWindowRect(window, before);
            }
        }

        IsFull = true;
        SetStyle(User32.Popup);
        Refill();
    }

    /// <summary>Fills the whole monitor again, such as when its resolution has changed.</summary>
    public void Refill() => Put(Monitor.All, User32.FrameChanged);

    /// <summary>Is again as before <see cref="Fill"/>.</summary>
    public void Unfill()
    {
        IsFull = false;
        SetStyle(Normal);
        Put(_before, User32.FrameChanged);
    }

    private void SetStyle(uint style) =>
        _ = User32.SetWindowLong(window, User32.Style, (nint)(style | User32.ClipChildren | (IsVisible ? User32.Visible : 0)));
}
