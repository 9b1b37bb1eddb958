using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.LogicalTree;

namespace ErrorMatching.Hmi;

/// <summary>The parts of a view, which are laid out one after the other, the outer ones first: all of them at once would keep whoever presses a key waiting.</summary>
internal sealed class Unfolding
{
    private readonly Control _view;
    private readonly Queue<(Control Part, IDisposable? Cover)> _parts = new();

    /// <summary>Hides the parts of a view until each has come.</summary>
    /// <param name="view">The view, before it is shown.</param>
    /// <param name="least">How many controls within a part make it worth a step of its own; those with fewer come with what they stand in.</param>
    public Unfolding(Control view, int least)
    {
        _view = view;
        Control[] parts = [.. view.GetLogicalDescendants().OfType<Control>().Where(c => c.Parent is Panel && c.GetLogicalDescendants().Take(least).Count() == least)];
        foreach (var part in parts)
        {
            // Goes before whatever else says whether it is seen, and changes none of that.
            _parts.Enqueue((part, part.SetValue(Visual.IsVisibleProperty, false, BindingPriority.Animation)));
        }
    }

    /// <summary>The part that comes next; null once all have come.</summary>
    public Control? Coming => _parts.TryPeek(out var next) ? next.Part : null;

    /// <summary>Lets the next part come.</summary>
    public void Next()
    {
        _parts.Dequeue().Cover?.Dispose();
        _view.UpdateLayout();
    }
}
