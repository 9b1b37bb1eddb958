using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Completes a tap on a tile or row that is recreated or moved while the finger is down: the press counts.</summary>
internal sealed class TapKeeper
{
    // A longer movement is a drag, not a tap on what it began at.
    private const double Still = 8;

    private readonly MainWindow _window;
    private readonly HashSet<int> _refused = [];
    private Control? _pressed;
    private string _id = "";
    private Point _at;

    /// <summary>Watches the taps of a window.</summary>
    public TapKeeper(MainWindow window)
    {
        _window = window;
        window.AddHandler(InputElement.PointerPressedEvent, OnPressed, RoutingStrategies.Tunnel, handledEventsToo: true);
        window.AddHandler(InputElement.PointerReleasedEvent, OnReleased, RoutingStrategies.Tunnel, handledEventsToo: true);
    }

    // Only navigation. A button that decides something must still be under the finger when it is lifted.
    internal static bool IsKept(Control control) => control is ListBoxItem || (control is Button && control.Classes.Contains("tile"));

    private void OnPressed(object? sender, PointerPressedEventArgs e)
    {
        // If the press was refused, so is the release, because a row is selected on release.
        _ = e.Handled ? _refused.Add(e.Pointer.Id) : _refused.Remove(e.Pointer.Id);
        _pressed = e.Pointer.IsPrimary && !e.Handled
            ? (e.Source as Visual)?.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(IsKept)
            : null;

        // Remember the row by its id: a recycled control loses it.
        _id = _pressed is null ? "" : AutomationProperties.GetAutomationId(_pressed) ?? "";
        _at = e.GetPosition(_window);
    }

    private void OnReleased(object? sender, PointerReleasedEventArgs e)
    {
        var (pressed, place) = (_pressed, e.GetPosition(_window));
        _pressed = null;
        e.Handled |= _refused.Remove(e.Pointer.Id);
        if (pressed is null || _id.Length == 0 || Point.Distance(place, _at) > Still || IsUnder(pressed, place))
        {
            return;
        }

        if (_window.GetVisualDescendants()
            .OfType<Control>()
            .FirstOrDefault(c => IsKept(c) && AutomationProperties.GetAutomationId(c) == _id && IsShown(c)) is { } anew)
        {
            Open(anew, e);
        }
    }

    private bool IsUnder(Control pressed, Point place) =>
        AutomationProperties.GetAutomationId(pressed) == _id
            && IsShown(pressed)
            && _window.TranslatePoint(place, pressed) is { } within
            && new Rect(pressed.Bounds.Size).Contains(within);

    private bool IsShown(Control control) =>
        control.IsEffectivelyVisible
            && control.IsEffectivelyEnabled
            && _window.IsVisualAncestorOf(control)
            && !_window.Stage.IsVisualAncestorOf(control);

    private static void Open(Control control, PointerReleasedEventArgs released)
    {
        if (control is ListBoxItem row)
        {
            row.IsSelected = true;
            row.RaiseEvent(new TappedEventArgs(InputElement.TappedEvent, released) { Source = row });
        }
        else if (ControlAutomationPeer.CreatePeerForElement(control) is ButtonAutomationPeer button)
        {
            button.Invoke();
        }
    }
}
