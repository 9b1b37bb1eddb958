using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>The row of a <see cref="TabControl"/>'s tabs takes one stop of the Tab key: the tab whose side is open.</summary>
internal static class TabRow
{
    /// <summary>Lets it be so for all of them.</summary>
    /// <remarks>
    /// A <see cref="TabControl"/> remembers for its row what had the focus last, also if that stands on the side that is open. Who goes back from there by Shift+Tab is led to the row, and by what it remembers to where they
    /// were: they never get out.
    /// </remarks>
    public static void Mend() => InputElement.GotFocusEvent.AddClassHandler<TabControl>(
        (tabs, _) => KeyboardNavigation.SetTabOnceActiveElement(tabs, tabs.ContainerFromIndex(tabs.SelectedIndex)),
        RoutingStrategies.Bubble,
        handledEventsToo: true);
}
