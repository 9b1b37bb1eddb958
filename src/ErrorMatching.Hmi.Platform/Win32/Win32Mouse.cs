using Avalonia.Input;
using Avalonia.Input.Raw;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The mouse on one window. A pen acts as one: the system makes mouse messages of it.</summary>
/// <param name="window">The window.</param>
internal sealed unsafe class Win32Mouse(Win32Window window)
{
    private const double Notch = 120;
    private const uint TellsOfLeaving = 2;
    private const RawInputModifiers Buttons =
        RawInputModifiers.LeftMouseButton | RawInputModifiers.RightMouseButton | RawInputModifiers.MiddleMouseButton;

    private bool _isInside;
    private bool _isCaptured;

    /// <summary>Handles a message.</summary>
    /// <returns>False for one that is not about the mouse.</returns>
    public bool On(uint message, nint w, nint l)
    {
        var held = Win32Keys.Held;
        switch (message)
        {
            case Win32Message.MouseLeaves:
                _isInside = false;
                window.Mouse(RawPointerEventType.LeaveWindow, new(-1, -1), held);
                return true;
            case Win32Message.Wheel:
                window.Wheel(window.AtScreen(l), new(0, Turned(w)), held);
                return true;
            case Win32Message.SidewaysWheel:
                window.Wheel(window.AtScreen(l), new(-Turned(w), 0), held);
                return true;
            case Win32Message.CaptureChanged:
                if (_isCaptured)
                {
                    // Another program took the mouse while a button was down: nothing is pressed.
                    _isCaptured = false;
                    window.Mouse(RawPointerEventType.CancelCapture, default, held);
                }

                return true;
        }

        if (Kind(message) is not { } kind)
        {
            return false;
        }

        if (!_isInside)
        {
            var tracking = new User32.Tracking { Bytes = sizeof(User32.Tracking), Flags = TellsOfLeaving, Window = window.Window };
            _isInside = User32.TrackMouseEvent(&tracking) != 0;
        }

        // As long as a button is down, the window also gets what happens outside of it.
        if (!_isCaptured && (held & Buttons) != RawInputModifiers.None && kind != RawPointerEventType.Move)
        {
            _ = User32.SetCapture(window.Window);
            _isCaptured = true;
        }
        else if (_isCaptured && (held & Buttons) == RawInputModifiers.None)
        {
            _isCaptured = false;
            _ = User32.ReleaseCapture();
        }

        window.Mouse(kind, window.At(l), held);
        return true;
    }

    private static double Turned(nint w) => (short)(w >> 16) / Notch;

    private static RawPointerEventType? Kind(uint message) => message switch
    {
        Win32Message.MouseMove => RawPointerEventType.Move,
        Win32Message.LeftDown => RawPointerEventType.LeftButtonDown,
        Win32Message.LeftUp => RawPointerEventType.LeftButtonUp,
        Win32Message.RightDown => RawPointerEventType.RightButtonDown,
        Win32Message.RightUp => RawPointerEventType.RightButtonUp,
        Win32Message.MiddleDown => RawPointerEventType.MiddleButtonDown,
        Win32Message.MiddleUp => RawPointerEventType.MiddleButtonUp,
        _ => null,
    };
}
