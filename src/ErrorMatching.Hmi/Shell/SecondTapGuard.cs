using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Prevents the second of two quick taps from hitting what the first one brought up: what was behind a dialog, or
/// another screen.</summary>
internal sealed class SecondTapGuard
{
    // Within this time no one has seen the result of a tap yet. A gloved finger returns within this distance.
    private const ulong TwiceMs = 500;
    private const double Near = 24;

    private readonly MainWindow _window;
    private (Control? Control, string Id) _under;
    private Point _at;
    private ulong _time;
    private bool _isFirst = true;

    /// <summary>Watches the taps of a window.</summary>
    public SecondTapGuard(MainWindow window)
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

    // A recreated row or tile counts as the same, and so do the keys of the keyboard; a control that shows something else does not.
    private static bool IsSame((Control? Control, string Id) now, (Control? Control, string Id) before) =>
        (now.Id == before.Id && (ReferenceEquals(now.Control, before.Control) || (now.Control is { } control && TapKeeper.IsKept(control))))
            || (IsKey(now.Control) && IsKey(before.Control));

    // Two neighboring keys are typed as quickly as one of them twice.
    private static bool IsKey(Control? control) => control is Button && control.Classes.Contains("key");

    private static (Control? Control, string Id) Under(object? source)
    {
        var control = (source as Visual)?.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(
            c => AutomationProperties.GetAutomationId(c) is { Length: > 0 });
        return (control, control is null ? "" : AutomationProperties.GetAutomationId(control)!);
    }
}
