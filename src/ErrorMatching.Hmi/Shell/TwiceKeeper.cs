using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Keeps the second of two quick taps in one place from falling on what the first brought there: behind a dialog that closed, or on another screen.</summary>
internal sealed class TwiceKeeper
{
    // So long after a tap nobody has yet seen what it brought; in a glove a finger comes back so near.
    private const ulong TwiceMs = 500;
    private const double Near = 24;

    private readonly MainWindow _window;
    private (Control? Control, string Id) _under;
    private Point _at;
    private ulong _time;
    private bool _isFirst = true;

    /// <summary>Keeps the taps of a window.</summary>
    public TwiceKeeper(MainWindow window)
    {
        _window = window;
        window.AddHandler(InputElement.PointerPressedEvent, OnPressed, RoutingStrategies.Tunnel, handledEventsToo: true);
    }

    private void OnPressed(object? sender, PointerPressedEventArgs e)
    {
        var (place, under) = (e.GetPosition(_window), Under(e.Source));
        var isTwice = !_isFirst && e.Timestamp - _time < TwiceMs && Point.Distance(place, _at) <= Near;
        if (isTwice && !IsSame(under, _under))
        {
            e.Handled = true;
            return;
        }

        (_under, _at, _time, _isFirst) = (under, place, e.Timestamp, false);
    }

    // A row or tile that was made anew is the same; a control that shows something else now is another.
    private static bool IsSame((Control? Control, string Id) now, (Control? Control, string Id) before) =>
        now.Id == before.Id && (ReferenceEquals(now.Control, before.Control) || (now.Control is { } control && TapKeeper.IsKept(control)));

    private static (Control? Control, string Id) Under(object? source)
    {
        var control = (source as Visual)?.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(c => AutomationProperties.GetAutomationId(c) is { Length: > 0 });
        return (control, control is null ? "" : AutomationProperties.GetAutomationId(control)!);
    }
}
