using Avalonia;
using Avalonia.Input.Raw;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The fingers on one window, as the X server reports them.</summary>
/// <param name="scaling">Pixels per device-independent unit.</param>
/// <param name="pass">Receives what a finger does, where in device-independent units, and which finger.</param>
internal sealed class X11Fingers(double scaling, Action<RawPointerEventType, Point, long> pass)
{
    private readonly Fingers _fingers = new(pass);

    /// <summary>Passes on what a finger does.</summary>
    public void On(XInputEvent finger)
    {
        var at = new Point(finger.X, finger.Y) / scaling;
        switch (finger.Kind)
        {
            case XInput.TouchBegin:
                _fingers.Begin(finger.Finger, at);
                break;
            case XInput.TouchUpdate when !finger.IsMarked:
                _fingers.Update(finger.Finger, at);
                break;

            // An end that is pending belongs to another client after all.
            case XInput.TouchEnd:
                _fingers.End(finger.Finger, at, finger.IsMarked);
                break;
        }
    }

    /// <summary>Cancels all touches.</summary>
    public void Cancel() => _fingers.Cancel();
}
