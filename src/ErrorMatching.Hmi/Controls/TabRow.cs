using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Makes the tab row of a <see cref="TabControl"/> a single tab stop: the selected tab.</summary>
internal static class TabRow
{
    /// <summary>Applies this to all tab controls.</summary>
    /// <remarks>A <see cref="TabControl"/> remembers the last focused element for its tab row, even if it is on the selected
    /// page. Shift+Tab from the page then leads to the row, and the row sends the focus back to that element: the user cannot
    /// leave the page.</remarks>
    public static void Mend() => InputElement.GotFocusEvent.AddClassHandler<TabControl>(
        (tabs, _) => KeyboardNavigation.SetTabOnceActiveElement(tabs, tabs.ContainerFromIndex(tabs.SelectedIndex)),
        RoutingStrategies.Bubble,
        handledEventsToo: true);
}
