using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>What the views of both setup screens share: undo and redo keys wherever the focus is, and going to a field.</summary>
internal abstract class SetupView : UserControl
{
    private SetupViewModel? _setup;
    private TopLevel? _window;
    private string? _wanted;

    protected SetupView()
    {
        LayoutUpdated += (_, _) => Look();
        AddHandler(GotFocusEvent, OnFocus, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);
        Follow(DataContext as SetupViewModel);
    }

    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        _window = TopLevel.GetTopLevel(this);
        _window?.AddHandler(KeyDownEvent, OnKey, RoutingStrategies.Bubble);
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        _window?.RemoveHandler(KeyDownEvent, OnKey);
        _wanted = null;
        Follow(null);
        base.OnDetachedFromVisualTree(e);
    }

    /// <summary>Scrolls to the row of a field, if it exists.</summary>
    protected virtual void ShowRow(string id)
    {
    }

    // The field may be on a tab that was just opened and is still loading.
    private void GoTo(string id)
    {
        _wanted = id;
        Look();
    }

    private void Look()
    {
        if (_wanted is not null)
        {
            Dispatcher.UIThread.Post(GoToWanted, DispatcherPriority.ContextIdle);
        }
    }

    private void GoToWanted()
    {
        if (_wanted is { } id)
        {
            ShowRow(id);
            if (SetupKeys.Focus(this, id))
            {
                _wanted = null;
            }
        }
    }

    private void Follow(SetupViewModel? setup)
    {
        if (_setup is not null)
        {
            _setup.FieldWanted -= GoTo;
        }

        _setup = setup;
        if (_setup is not null)
        {
            _setup.FieldWanted += GoTo;
        }
    }

    // Show the problem of the focused field.
    private void OnFocus(object? sender, FocusChangedEventArgs e)
    {
        if (e.Source is Control field
            && AutomationProperties.GetAutomationId(field) is { } id
            && id.StartsWith(EditField.IdStart, StringComparison.Ordinal))
        {
            _setup?.Look(id);
        }
    }

    private void OnKey(object? sender, KeyEventArgs e)
    {
        if (e is { Key: Key.Enter, Source: TextBox { Classes: var classes } } && classes.Contains("count"))
        {
            // Apply the input now, as when the field loses focus.
            Focusable = true;
            Focus();
            e.Handled = true;
        }

        SetupKeys.OnKey(_setup, e);
    }
}
