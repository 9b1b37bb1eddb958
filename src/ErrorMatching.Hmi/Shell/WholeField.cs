using System.Runtime.CompilerServices;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>A tap into a field takes all of its text, as the Tab key does: what is typed then is the new value, and not one that has the old one behind it. A second tap sets the caret, and what is drawn over is taken as it is drawn.</summary>
internal static class WholeField
{
    private static readonly ConditionalWeakTable<TextBox, object> Entered = [];

    /// <summary>Lets it be so for all of them.</summary>
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

    // A finger leaves what is selected as it is, and is offered a menu for it.
    private static void OnReleasing(TextBox field, PointerReleasedEventArgs e)
    {
        if (e.Pointer.Type is PointerType.Touch && !Entered.TryGetValue(field, out _) && field.SelectedText == field.Text)
        {
            field.ClearSelection();
        }
    }

    // Behind the press that brought the focus, which sets the caret, and behind the release, which has the menu.
    private static void OnReleased(TextBox field, PointerReleasedEventArgs e)
    {
        if (Entered.Remove(field) && field.SelectionStart == field.SelectionEnd)
        {
            Dispatcher.UIThread.Post(field.SelectAll, DispatcherPriority.Input);
        }
    }
}
