using Avalonia.Automation;
using Avalonia.Automation.Peers;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The numbers that UI Automation has for kinds of controls (UIA_..ControlTypeId) and for what opens.</summary>
internal static class UiaRole
{
    private const int First = 50000, Custom = 50025, Group = 50026, ListItem = 50007, Pane = 50033;

    // In the order of their numbers, from 50000 on.
    private static readonly AutomationControlType[] InOrder =
    [
        AutomationControlType.Button, AutomationControlType.Calendar, AutomationControlType.CheckBox, AutomationControlType.ComboBox,
        AutomationControlType.Edit, AutomationControlType.Hyperlink, AutomationControlType.Image, AutomationControlType.ListItem,
        AutomationControlType.List, AutomationControlType.Menu, AutomationControlType.MenuBar, AutomationControlType.MenuItem,
        AutomationControlType.ProgressBar, AutomationControlType.RadioButton, AutomationControlType.ScrollBar, AutomationControlType.Slider,
        AutomationControlType.Spinner, AutomationControlType.StatusBar, AutomationControlType.Tab, AutomationControlType.TabItem,
        AutomationControlType.Text, AutomationControlType.ToolBar, AutomationControlType.ToolTip, AutomationControlType.Tree,
        AutomationControlType.TreeItem, AutomationControlType.Custom, AutomationControlType.Group, AutomationControlType.Thumb,
        AutomationControlType.DataGrid, AutomationControlType.DataItem, AutomationControlType.Document, AutomationControlType.SplitButton,
        AutomationControlType.Window, AutomationControlType.Pane, AutomationControlType.Header, AutomationControlType.HeaderItem,
        AutomationControlType.Table, AutomationControlType.TitleBar, AutomationControlType.Separator,
    ];

    /// <summary>The number of a kind.</summary>
    public static int Of(AutomationControlType kind) => kind switch
    {
        AutomationControlType.None => Group,
        AutomationControlType.ScrollViewer => Pane,
        AutomationControlType.ComboBoxItem => ListItem,
        AutomationControlType.Expander => Group,
        _ => Array.IndexOf(InOrder, kind) is >= 0 and var at ? First + at : Custom,
    };

    /// <summary>The number of a state of what opens, which Avalonia counts in another order.</summary>
    public static int Of(ExpandCollapseState state) => state switch
    {
        ExpandCollapseState.Collapsed => 0,
        ExpandCollapseState.Expanded => 1,
        ExpandCollapseState.PartiallyExpanded => 2,
        _ => 3,
    };
}
