using Avalonia;
using Avalonia.Input.Raw;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The fingers on one window, passed on as touches.</summary>
/// <param name="scaling">Pixels per device-independent unit.</param>
/// <param name="pass">Receives what a finger does, where in device-independent units, and which finger.</param>
internal sealed class X11Fingers(double scaling, Action<RawPointerEventType, Point, long> pass)
{
    private readonly Dictionary<uint, Point> _down = [];

    /// <summary>Passes on what a finger does.</summary>
    public void On(XInputEvent finger)
    {
        var at = new Point(finger.X, finger.Y) / scaling;
        switch (finger.Kind)
        {
            case XInput.TouchBegin:
                _down[finger.Finger] = at;
                pass(RawPointerEventType.TouchBegin, at, finger.Finger);
                break;
            case XInput.TouchUpdate when _down.ContainsKey(finger.Finger) && !finger.IsMarked:
                _down[finger.Finger] = at;
                pass(RawPointerEventType.TouchUpdate, at, finger.Finger);
                break;

            // An end that is pending belongs to another client after all: it must press nothing here.
            case XInput.TouchEnd when _down.Remove(finger.Finger):
                pass(finger.IsMarked ? RawPointerEventType.TouchCancel : RawPointerEventType.TouchEnd, at, finger.Finger);
                break;
        }
    }

    /// <summary>Cancels all touches, such as when the window closes: they press nothing. Fingers that are still down are ignored until
    /// they are lifted.</summary>
    public void Cancel()
    {
        foreach (var (id, at) in _down.ToArray())
        {
            _down.Remove(id);
            pass(RawPointerEventType.TouchCancel, at, id);
        }
    }
}
