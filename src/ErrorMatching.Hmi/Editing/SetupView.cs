using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>What the views of both set-up screens share: undo and redo by keys wherever the focus is, and going to a field.</summary>
public abstract class SetupView : UserControl
{
    private SetupViewModel? _setup;
    private TopLevel? _window;

    /// <inheritdoc/>
    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);
        Follow(DataContext as SetupViewModel);
    }

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        _window = TopLevel.GetTopLevel(this);
        _window?.AddHandler(KeyDownEvent, OnKey, RoutingStrategies.Bubble);
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        _window?.RemoveHandler(KeyDownEvent, OnKey);
        Follow(null);
        base.OnDetachedFromVisualTree(e);
    }

    /// <summary>Brings a field into view and puts the focus there.</summary>
    protected virtual void GoTo(string id) => SetupKeys.Focus(this, id);

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

    private void OnKey(object? sender, KeyEventArgs e)
    {
        if (e is { Key: Key.Enter, Source: TextBox { Classes: var classes } } && classes.Contains("count"))
        {
            // What was typed counts now, as it does when the field is left.
            Focusable = true;
            Focus();
            e.Handled = true;
        }

        SetupKeys.OnKey(_setup, e);
    }
}
