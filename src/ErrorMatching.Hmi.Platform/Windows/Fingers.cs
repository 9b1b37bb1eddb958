using Avalonia;
using Avalonia.Input.Raw;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The fingers on one window, passed on as touches.</summary>
/// <param name="pass">Receives what a finger does, where in device-independent units, and which finger.</param>
internal sealed class Fingers(Action<RawPointerEventType, Point, long> pass)
{
    private readonly Dictionary<uint, Point> _down = [];

    /// <summary>A finger touches the window.</summary>
    public void Begin(uint finger, Point at)
    {
        if (_down.TryAdd(finger, at))
        {
            pass(RawPointerEventType.TouchBegin, at, finger);
        }
    }

    /// <summary>A finger moves.</summary>
    public void Update(uint finger, Point at)
    {
        if (_down.ContainsKey(finger))
        {
            _down[finger] = at;
            pass(RawPointerEventType.TouchUpdate, at, finger);
        }
    }

    /// <summary>A finger is lifted; or it belongs to another program after all, and must press nothing here.</summary>
    public void End(uint finger, Point at, bool isCanceled)
    {
        if (_down.Remove(finger))
        {
            pass(isCanceled ? RawPointerEventType.TouchCancel : RawPointerEventType.TouchEnd, at, finger);
        }
    }

    /// <summary>Cancels a touch, where the finger was last.</summary>
    public void Cancel(uint finger)
    {
        if (_down.Remove(finger, out var at))
        {
            pass(RawPointerEventType.TouchCancel, at, finger);
        }
    }

    /// <summary>Cancels all touches, such as when the window closes: they press nothing. Fingers that are still down are ignored until
    /// they are lifted.</summary>
    public void Cancel()
    {
        foreach (var finger in _down.Keys.ToArray())
        {
            Cancel(finger);
        }
    }
}
