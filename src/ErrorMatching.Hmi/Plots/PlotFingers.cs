using Avalonia;
using Avalonia.Input;

namespace ErrorMatching.Hmi;

/// <summary>The fingers or the pointer on a plot: one pans, two zoom, and a tap is one that did not move.</summary>
/// <param name="plot">The plot.</param>
internal sealed class PlotFingers(PlotArea plot)
{
    private readonly Dictionary<int, Point> _fingers = [];
    private Point _pressed;
    private bool _hasMoved;

    public void Press(PointerPressedEventArgs e)
    {
        var at = e.GetPosition(plot);
        if (_fingers.Count == 0)
        {
            (_pressed, _hasMoved) = (at, false);
        }

        _fingers[e.Pointer.Id] = at;
        e.Pointer.Capture(plot);
        e.PreventGestureRecognition();
        e.Handled = true;
    }

    public void Move(PointerEventArgs e)
    {
        if (!_fingers.TryGetValue(e.Pointer.Id, out var before))
        {
            return;
        }

        var at = e.GetPosition(plot);
        if (_fingers.Count > 1)
        {
            // Two fingers: the places under both stay under them, as far as a single scale allows.
            var other = _fingers.First(f => f.Key != e.Pointer.Id).Value;
            _hasMoved = true;
            var (was, now) = (Point.Distance(before, other), Point.Distance(at, other));
            plot.Pan((at - before) / 2);
            if (was > DrawnSizes.FingerStill && now > DrawnSizes.FingerStill)
            {
                plot.Zoom(now / was, (at + other) / 2);
            }
        }
        else if (_hasMoved || Point.Distance(at, _pressed) > DrawnSizes.FingerStill)
        {
            plot.Pan(at - (_hasMoved ? before : _pressed));
            _hasMoved = true;
        }

        _fingers[e.Pointer.Id] = at;
        e.Handled = true;
    }

    /// <summary>Lifts a finger.</summary>
    /// <returns>True if it was a tap.</returns>
    public bool Release(PointerReleasedEventArgs e)
    {
        e.Handled = true;
        return _fingers.Remove(e.Pointer.Id) && _fingers.Count == 0 && !_hasMoved;
    }

    public void Lose(PointerCaptureLostEventArgs e) => _fingers.Remove(e.Pointer.Id);
}
