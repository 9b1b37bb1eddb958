using System.Runtime.CompilerServices;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>The first tap on a field selects all of its text, as the Tab key does, so that typing replaces the old value. A
/// second tap sets the caret, and dragging selects text as usual.</summary>
internal static class WholeField
{
    private static readonly ConditionalWeakTable<TextBox, object> Entered = [];

    /// <summary>Applies this to all text boxes.</summary>
    public static void Mend()
    {
        InputElement.GotFocusEvent.AddClassHandler<TextBox>(OnGotFocus);
        InputElement.LostFocusEvent.AddClassHandler<TextBox>((field, _) => Entered.Remove(field));
        InputElement.PointerReleasedEvent.AddClassHandler<TextBox>(OnReleasing, RoutingStrategies.Tunnel);
        InputElement.PointerReleasedEvent.AddClassHandler<TextBox>(OnReleased, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    private static void OnGotFocus(TextBox field, FocusChangedEventArgs e)
    {
        if (e.NavigationMethod == NavigationMethod.Pointer)
        {
            Entered.AddOrUpdate(field, field);
        }
    }

    // A touch keeps a full selection and opens a menu for it; clear it first, so that a second tap sets the caret.
    private static void OnReleasing(TextBox field, PointerReleasedEventArgs e)
    {
        if (e.Pointer.Type is PointerType.Touch && !Entered.TryGetValue(field, out _) && field.SelectedText == field.Text)
        {
            field.ClearSelection();
        }
    }

    // Posted, so that it runs after the press that focuses the field and sets the caret, and after the release that opens the menu.
    private static void OnReleased(TextBox field, PointerReleasedEventArgs e)
    {
        if (Entered.Remove(field) && field.SelectionStart == field.SelectionEnd)
        {
            Dispatcher.UIThread.Post(field.SelectAll, DispatcherPriority.Input);
        }
    }
}
