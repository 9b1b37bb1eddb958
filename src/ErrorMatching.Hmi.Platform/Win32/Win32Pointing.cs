namespace ErrorMatching.Hmi.Platform;

/// <summary>The fingers on one window (WM_POINTER), each by itself.</summary>
/// <param name="window">The window.</param>
internal sealed unsafe class Win32Pointing(Win32Window window)
{
    private const int Pen = 3;
    private const nint Canceled = 0x8000;
    private readonly Fingers _fingers = new(window.Touch);

    /// <summary>Handles a message.</summary>
    /// <returns>False for one that is not about a finger. The system makes mouse messages of a pen's.</returns>
    public bool On(uint message, nint w, nint l)
    {
        var finger = (uint)(w & 0xFFFF);
        if (message == Win32Message.PointerCaptureChanged)
        {
            _fingers.Cancel(finger);
            return true;
        }

        // A mouse sends such messages only to programs that ask for them. Wine calls every pointer a mouse.
        int type;
        if (message is not (Win32Message.PointerDown or Win32Message.PointerUpdate or Win32Message.PointerUp)
            || User32.GetPointerType(finger, &type) == 0 || type == Pen)
        {
            return false;
        }

        var at = window.AtScreen(l);
        switch (message)
        {
            case Win32Message.PointerDown:
                _fingers.Begin(finger, at);
                break;
            case Win32Message.PointerUpdate:
                _fingers.Update(finger, at);
                break;
            default:
                _fingers.End(finger, at, ((w >> 16) & Canceled) != 0);
                break;
        }

        return true;
    }

    /// <summary>Cancels all touches, such as when the window closes.</summary>
    public void Cancel() => _fingers.Cancel();
}
