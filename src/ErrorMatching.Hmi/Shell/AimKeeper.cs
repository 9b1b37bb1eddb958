using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Prevents a tap from hitting another tile or row than intended: if a list has just changed and another row was under
/// the finger a moment ago, the tap is ignored.</summary>
internal sealed class AimKeeper
{
    /// <summary>Time that a finger needs to reach its target.</summary>
    public static readonly TimeSpan OnItsWay = TimeSpan.FromMilliseconds(500);

    private readonly MainWindow _window;
    private readonly List<(long At, (string Id, Rect Place)[] Rows)> _seen = [];

    /// <summary>Watches the taps of a window while it is open.</summary>
    public AimKeeper(MainWindow window)
    {
        _window = window;
        window.AddHandler(InputElement.PointerPressedEvent, OnPressed, RoutingStrategies.Tunnel, handledEventsToo: true);
        RowsChange.Coming += Remember;
        window.Closed += (_, _) => RowsChange.Coming -= Remember;
    }

    private ShellViewModel? Shell => _window.DataContext as ShellViewModel;

    /// <summary>True if a tap must be ignored now.</summary>
    /// <param name="under">The element under the finger.</param>
    /// <param name="place">The finger's position in the window.</param>
    internal bool IsMissed(object? under, Point place)
    {
        Forget();
        return (under as Visual)?.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(TapKeeper.IsKept) is { } now
            && AutomationProperties.GetAutomationId(now) is { Length: > 0 } id
            && _seen.Exists(s => s.Rows.Any(r => r.Place.Contains(place)) && !s.Rows.Any(r => r.Id == id && r.Place.Contains(place)));
    }

    /// <summary>Called when another screen is shown: its rows have not moved.</summary>
    internal void Leave() => _seen.Clear();

    private void OnPressed(object? sender, PointerPressedEventArgs e)
    {
        if (!e.Handled)
        {
            e.Handled = IsMissed(e.Source, e.GetPosition(_window));
        }
    }

    private void Remember()
    {
        if (Shell is { } shell)
        {
            Forget();
            _seen.Add((shell.Station.Clock.GetTimestamp(), [.. Rows(_window)]));
        }
    }

    private void Forget() => _seen.RemoveAll(s => Shell is not { } shell || shell.Station.Clock.GetElapsedTime(s.At) >= OnItsWay);

    private IEnumerable<(string Id, Rect Place)> Rows(Visual within)
    {
        foreach (var visual in within.GetVisualChildren().Where(v => v.IsVisible && v != _window.Stage))
        {
            if (visual is not Control control || !TapKeeper.IsKept(control))
            {
                foreach (var row in Rows(visual))
                {
                    yield return row;
                }
            }
            else if (AutomationProperties.GetAutomationId(control) is { Length: > 0 } id
                && control.TranslatePoint(default, _window) is { } corner)
            {
                yield return (id, new(corner, control.Bounds.Size));
            }
        }
    }
}
