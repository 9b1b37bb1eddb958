using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.LogicalTree;

namespace ErrorMatching.Hmi;

/// <summary>Lays out the parts of a view one after another, outer ones first. All at once would delay key presses.</summary>
internal sealed class Unfolding
{
    private readonly Control _view;
    private readonly Queue<(Control Part, IDisposable? Cover)> _parts = new();

    /// <summary>Hides the parts of a view until their turn.</summary>
    /// <param name="view">The view, before it is shown.</param>
    /// <param name="least">Minimum number of controls for a part to get its own step; smaller parts appear with their parent.</param>
    public Unfolding(Control view, int least)
    {
        _view = view;
        Control[] parts = [
            .. view.GetLogicalDescendants()
                .OfType<Control>()
                .Where(c => c.Parent is Panel && c.GetLogicalDescendants().Take(least).Count() == least)];
        foreach (var part in parts)
        {
            // This priority overrides all other visibility settings without changing them.
            _parts.Enqueue((part, part.SetValue(Visual.IsVisibleProperty, false, BindingPriority.Animation)));
        }
    }

    /// <summary>The next part; null if all are shown.</summary>
    public Control? Coming => _parts.TryPeek(out var next) ? next.Part : null;

    /// <summary>Shows the next part.</summary>
    public void Next()
    {
        _parts.Dequeue().Cover?.Dispose();
        _view.UpdateLayout();
    }
}
