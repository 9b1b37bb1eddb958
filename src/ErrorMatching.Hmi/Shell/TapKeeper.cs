using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Keeps a tap on a tile or a row that is made anew, or moved away by another one, while the finger is down: what was pressed is what is meant.</summary>
internal sealed class TapKeeper
{
    // A finger that goes further drags, and means nothing that it began at.
    private const double Still = 8;

    private readonly MainWindow _window;
    private readonly HashSet<int> _refused = [];
    private Control? _pressed;
    private string _id = "";
    private Point _at;

    /// <summary>Keeps the taps of a window.</summary>
    public TapKeeper(MainWindow window)
    {
        _window = window;
        window.AddHandler(InputElement.PointerPressedEvent, OnPressed, RoutingStrategies.Tunnel, handledEventsToo: true);
        window.AddHandler(InputElement.PointerReleasedEvent, OnReleased, RoutingStrategies.Tunnel, handledEventsToo: true);
    }

    // Only what leads somewhere: a button that decides must be pressed as it stands there when the finger is lifted.
    internal static bool IsKept(Control control) => control is ListBoxItem || (control is Button && control.Classes.Contains("tile"));

    private void OnPressed(object? sender, PointerPressedEventArgs e)
    {
        // What was not taken when the finger came down is not taken when it is lifted: a row is chosen by that.
        _ = e.Handled ? _refused.Add(e.Pointer.Id) : _refused.Remove(e.Pointer.Id);
        _pressed = e.Pointer.IsPrimary && !e.Handled ? (e.Source as Visual)?.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(IsKept) : null;

        // By the name of the row, which its control forgets with it.
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

        if (_window.GetVisualDescendants().OfType<Control>().FirstOrDefault(c => IsKept(c) && AutomationProperties.GetAutomationId(c) == _id && IsShown(c)) is { } anew)
        {
            Open(anew);
        }
    }

    private bool IsUnder(Control pressed, Point place) =>
        AutomationProperties.GetAutomationId(pressed) == _id && IsShown(pressed) && _window.TranslatePoint(place, pressed) is { } within && new Rect(pressed.Bounds.Size).Contains(within);

    private bool IsShown(Control control) => control.IsEffectivelyVisible && control.IsEffectivelyEnabled && _window.IsVisualAncestorOf(control) && !_window.Stage.IsVisualAncestorOf(control);

    private static void Open(Control control)
    {
        if (control is ListBoxItem row)
        {
            row.IsSelected = true;
        }
        else if (ControlAutomationPeer.CreatePeerForElement(control) is ButtonAutomationPeer button)
        {
            button.Invoke();
        }
    }
}
