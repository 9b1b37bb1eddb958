using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Keyboard and focus handling of both setup screens.</summary>
internal static class SetupKeys
{
    public static void OnKey(SetupViewModel? setup, KeyEventArgs e)
    {
        if (setup is null
            || e.Handled
            || !setup.IsInFront
            || !e.KeyModifiers.HasFlag(KeyModifiers.Control)
            || e.Key is not (Key.Z or Key.Y))
        {
            return;
        }

        var isRedo = e.Key == Key.Y || e.KeyModifiers.HasFlag(KeyModifiers.Shift);
        (isRedo ? setup.Editing.Redo : setup.Editing.Undo).Execute(null);
        e.Handled = true;
    }

    /// <summary>Brings a field into view and focuses it; false if it is not visible yet.</summary>
    public static bool Focus(Visual screen, string id)
    {
        if (screen.GetVisualDescendants()
            .OfType<InputElement>()
            .FirstOrDefault(c => AutomationProperties.GetAutomationId(c) == id && c.IsEffectivelyVisible) is not Control field)
        {
            return false;
        }

        // Include its name, which is above it in the same view, once the view is arranged.
        var whole = field.GetVisualParent() is Control { } around && around.Bounds.Height < screen.Bounds.Height / 2 ? around : field;
        whole.BringIntoView();
        Dispatcher.UIThread.Post(whole.BringIntoView, DispatcherPriority.Loaded);
        return field.Focus();
    }
}
