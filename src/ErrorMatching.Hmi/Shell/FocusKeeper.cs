using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Keeps the keyboard focus in place while a dialog is in front, and when the focused row is recreated.</summary>
internal sealed class FocusKeeper
{
    private readonly MainWindow _window;
    private Control? _focused;
    private string? _id;
    private Control? _behind;

    /// <summary>Watches the focus of a window.</summary>
    public FocusKeeper(MainWindow window)
    {
        _window = window;
        window.AddHandler(InputElement.GotFocusEvent, (_, e) => Follow(e.Source as Control));
    }

    /// <summary>Called when a dialog opens or closes; the dialog takes the focus.</summary>
    /// <param name="isFree">True if no dialog is open.</param>
    public void Cover(bool isFree)
    {
        if (!isFree)
        {
            _behind = _window.FocusManager?.GetFocusedElement() as Control ?? _behind;

            // Before the next key: several keys may be handled before the next layout.
            _window.UpdateLayout();
            _window.GetVisualDescendants().OfType<SigningView>().FirstOrDefault()?.TakeFocus();
        }
        else if (_behind is { } behind)
        {
            _behind = null;
            Dispatcher.UIThread.Post(() => behind.Focus(), DispatcherPriority.Loaded);
        }
    }

    private void Follow(Control? focused)
    {
        if (_focused is not null)
        {
            _focused.LostFocus -= OnLost;
        }

        // Remember the row by its id: a recycled control loses it.
        (_focused, _id) = (focused, focused is null ? null : AutomationProperties.GetAutomationId(focused));
        if (_focused is not null)
        {
            _focused.LostFocus += OnLost;
        }
    }

    private void OnLost(object? sender, FocusChangedEventArgs e)
    {
        var lost = _id;
        Follow(null);
        if (lost is { } id && e.NewFocusedElement is null)
        {
            Dispatcher.UIThread.Post(() => Return(id), DispatcherPriority.Loaded);
        }
    }

    private void Return(string id)
    {
        if (_window.FocusManager?.GetFocusedElement() is null)
        {
            _window.GetVisualDescendants()
                .OfType<Control>()
                .FirstOrDefault(c => AutomationProperties.GetAutomationId(c) == id && c.IsEffectivelyVisible)
                ?.Focus(_window.IsByKeyboard ? NavigationMethod.Tab : NavigationMethod.Unspecified);
        }
    }
}
