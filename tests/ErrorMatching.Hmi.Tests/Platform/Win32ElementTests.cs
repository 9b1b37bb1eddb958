using System.Runtime.InteropServices;
using System.Runtime.InteropServices.Marshalling;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using ErrorMatching.Cell;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What Windows' screen readers learn of controls and do to them, through the interfaces as another program has them: tables of
/// functions in memory. That they are the system's own, tests/station-under-wine shows from another process.</summary>
public sealed unsafe class Win32ElementTests
{
    private const int Button = 50000, CheckBox = 50002, Edit = 50004, Next = 1, First = 3;

    // UIA_E_ELEMENTNOTENABLED, UIA_E_ELEMENTNOTAVAILABLE and E_INVALIDARG.
    private const int NotEnabled = unchecked((int)0x80040200), NotAvailable = unchecked((int)0x80040201);
    private const int Invalid = unchecked((int)0x80070057);
    private static readonly StrategyBasedComWrappers Wrappers = new();

    [Fact]
    public Task An_element_has_the_name_and_the_role_of_its_control() => Shown((panel, _, _) =>
    {
        var first = Of<IFragmentProvider>(panel).Navigate(First)!;
        Assert.Equal(("Approve", Button, "approve"), Said(first));
        var second = first.Navigate(Next)!;
        Assert.Equal(("Serial number", Edit, "serial"), Said(second));
        Assert.Equal(("Serial number", Edit, "serial"), Said(second.Navigate(Next)!.Navigate(2)!));
        Assert.Null(Last(panel).Navigate(Next));
        Assert.Equal(50032, Said(first.Navigate(0)!).Role);
        Assert.Equal(("Password", Edit, "secret"), Said(second.Navigate(Next)!));
        Assert.Equal(("Dark", CheckBox, "dark"), Said(Last(panel)));
        Assert.Equal(true, Property(Of<IElementProvider>(panel.Children[0]), Uia.IsEnabled));
    });

    [Fact]
    public Task A_button_is_pressed_and_a_disabled_one_refuses() => Shown((panel, _, user) =>
    {
        var button = (Button)panel.Children[0];
        var pressed = 0;
        button.Click += (_, _) => pressed++;
        var element = Of<IElementProvider>(button);
        ((IInvoked)element.GetPattern(Uia.Invoke)!).Invoke();

        // It is done as the next input.
        Assert.Equal(0, pressed);
        user.Settle();
        Assert.Equal(1, pressed);
        Assert.Null(element.GetPattern(Uia.Value));
        Assert.Null(element.GetPattern(Uia.Toggle));
        Of<IInvoked>(button).Invoke();
        button.IsEnabled = false;
        user.Settle();
        Assert.Equal(1, pressed);
        Refuses(NotEnabled, () => Of<IInvoked>(button).Invoke());
        Assert.Equal(false, Property(element, Uia.IsEnabled));
        button.IsEnabled = true;
        button.IsVisible = false;
        Refuses(NotEnabled, () => Of<IInvoked>(button).Invoke());
    });

    [Fact]
    public Task A_text_is_read_and_written_but_no_password_is_read() => Shown((panel, _, _) =>
    {
        var serial = (TextBox)panel.Children[1];
        Of<IValued>(serial).SetValue("0042");
        Assert.Equal("0042", serial.Text);
        serial.Text = "0043 零";
        Assert.Equal("0043 零", Of<IValued>(serial).GetValue());
        Assert.Equal(0, Of<IValued>(serial).GetIsReadOnly());
        Assert.Equal(false, Property(Of<IElementProvider>(serial), Uia.IsPassword));
        serial.MaxLength = 8;
        Refuses(Invalid, () => Of<IValued>(serial).SetValue("012345678"));
        serial.IsReadOnly = true;
        Refuses(NotEnabled, () => Of<IValued>(serial).SetValue("1"));
        serial.IsReadOnly = false;
        panel.IsEnabled = false;
        Refuses(NotEnabled, () => Of<IValued>(serial).SetValue("1"));
        Assert.Equal("0043 零", serial.Text);
        panel.IsEnabled = true;

        var password = (TextBox)panel.Children[2];
        password.Text = "four words that nobody knows";
        Assert.Equal("", Of<IValued>(password).GetValue());
        Assert.Equal(true, Property(Of<IElementProvider>(password), Uia.IsPassword));
        Assert.Equal(("Password", Edit, "secret"), Said(Of<IFragmentProvider>(password)));
        Assert.Null(Of<IFragmentProvider>(password).Navigate(First));
    });

    [Fact]
    public Task What_is_on_or_off_says_so() => Shown((panel, _, user) =>
    {
        var dark = (CheckBox)panel.Children[3];
        var element = Of<IToggled>(dark);
        Assert.Equal(0, element.GetState());
        element.Toggle();
        user.Settle();
        Assert.True(dark.IsChecked);
        Assert.Equal(1, element.GetState());
    });

    [Fact]
    public Task A_choice_opens_and_takes_one_but_not_while_it_is_disabled() => Shown((panel, _, user) =>
    {
        var choice = new ComboBox { ItemsSource = new[] { "line", "curve" } };
        panel.Children.Add(choice);
        user.Settle();
        var element = Of<IExpanded>(choice);
        Assert.Equal(0, element.GetState());
        element.Expand();
        user.Settle();
        Assert.Equal(1, element.GetState());
        var curve = (ComboBoxItem)choice.ContainerFromIndex(1)!;
        choice.IsEnabled = false;
        Refuses(NotEnabled, () => Of<ISelected>(curve).Select());
        Refuses(NotEnabled, element.Collapse);
        choice.IsEnabled = true;
        Of<ISelected>(curve).Select();
        user.Settle();
        Assert.Equal(1, choice.SelectedIndex);
        Assert.Equal(1, Of<ISelected>(curve).GetIsSelected());
    });

    [Fact]
    public Task What_is_gone_says_and_does_nothing_any_more() => Shown((panel, _, user) =>
    {
        var (serial, element) = ((TextBox)panel.Children[1], Of<IValued>(panel.Children[1]));
        serial.Text = "0042";
        panel.Children.Remove(serial);
        user.Settle();
        Refuses(NotAvailable, () => element.GetValue());
        Refuses(NotAvailable, () => element.SetValue("0043"));
        Refuses(NotAvailable, () => Said((IFragmentProvider)element));
        Assert.Equal("0042", serial.Text);
    });

    [Fact]
    public Task Nothing_behind_a_question_can_be_pressed() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        var (approve, leave) = (seat.See("approve"), seat.See("sign-out"));
        seat.WaitFor(() => approve.IsEffectivelyEnabled, "Nothing can be approved.");
        Assert.Equal(true, Property(Of<IElementProvider>(leave), Uia.IsEnabled));
        Of<IInvoked>(approve).Invoke();
        seat.WaitFor(() => seat.Find("signing-password") is not null, "Nobody asks for a signature.");
        Assert.Equal(false, Property(Of<IElementProvider>(leave), Uia.IsEnabled));
        Refuses(NotEnabled, () => Of<IInvoked>(leave).Invoke());
        Refuses(NotEnabled, () => Of<IInvoked>(approve).Invoke());
        seat.User.Settle();
        Assert.False(seat.Shell.IsLocked);
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    [Fact]
    public Task The_window_knows_who_has_the_focus_and_what_is_where() => Shown((panel, window, _) =>
    {
        var root = Of<IFragmentRootProvider>(window);
        Of<IFragmentProvider>(panel.Children[1]).SetFocus();
        Assert.True(panel.Children[1].IsKeyboardFocusWithin);
        Assert.Equal(("Serial number", Edit, "serial"), Said(root.GetFocused()!));
        Assert.Equal(true, Property(Of<IElementProvider>(panel.Children[1]), Uia.HasFocus));

        var bounds = Of<IFragmentProvider>(panel.Children[3]).GetBounds();
        Assert.Equal(panel.Children[3].Bounds.Height * window.RenderScaling, bounds.Height, 1.0);
        var at = root.GetElementAt(bounds.Left + (bounds.Width / 2), bounds.Top + (bounds.Height / 2))!;
        Assert.Equal("Dark", Said(at).Name);
        Assert.Null(Of<IFragmentProvider>(window).Navigate(0));
        Assert.Same(Element(window), Of<IFragmentProvider>(panel.Children[1]).GetRoot());
    });

    [Fact]
    public void Each_kind_of_control_has_the_system_s_number()
    {
        // UIAutomationClient.h: UIA_ButtonControlTypeId is 50000, and so on.
        (AutomationControlType, int)[] numbers =
        [
            (AutomationControlType.Button, 50000), (AutomationControlType.ComboBox, 50003), (AutomationControlType.Image, 50006),
            (AutomationControlType.ComboBoxItem, 50007), (AutomationControlType.List, 50008), (AutomationControlType.ProgressBar, 50012),
            (AutomationControlType.ScrollBar, 50014), (AutomationControlType.Tab, 50018), (AutomationControlType.TabItem, 50019),
            (AutomationControlType.Text, 50020), (AutomationControlType.TreeItem, 50024), (AutomationControlType.Group, 50026),
            (AutomationControlType.DataItem, 50029), (AutomationControlType.Document, 50030), (AutomationControlType.Window, 50032),
            (AutomationControlType.Pane, 50033), (AutomationControlType.Table, 50036), (AutomationControlType.Separator, 50038),
        ];
        Assert.All(numbers, n => Assert.Equal(n.Item2, UiaRole.Of(n.Item1)));
        Assert.All(Enum.GetValues<AutomationControlType>(), t => Assert.InRange(UiaRole.Of(t), 50000, 50038));
        Assert.Equal([AutomationControlType.Custom], Enum.GetValues<AutomationControlType>().Where(t => UiaRole.Of(t) == 50025));

        // ExpandCollapseState_Collapsed, _Expanded, _PartiallyExpanded and _LeafNode.
        Assert.Equal(
            [0, 1, 2, 3],
            new[]
            {
                ExpandCollapseState.Collapsed, ExpandCollapseState.Expanded, ExpandCollapseState.PartiallyExpanded,
                ExpandCollapseState.LeafNode
            }.Select(UiaRole.Of));
    }

    private static void Refuses(int code, Action act) => Assert.Equal(code, Assert.ThrowsAny<Exception>(act).HResult);

    private static IFragmentProvider Last(Panel panel) => Of<IFragmentProvider>(panel).Navigate(4)!;

    private static (string? Name, int Role, string? Id) Said(IFragmentProvider element) => (
        (string?)Property((IElementProvider)element, Uia.Name),
        (int)Property((IElementProvider)element, Uia.ControlType)!,
        (string?)Property((IElementProvider)element, Uia.Id));

    private static object? Property(IElementProvider element, int property)
    {
        ComVariant value;
        element.GetProperty(property, &value);
        using (value)
        {
            return value.VarType switch
            {
                VarEnum.VT_BSTR => value.As<string>(),
                VarEnum.VT_I4 => value.As<int>(),
                VarEnum.VT_BOOL => value.As<bool>(),
                _ => null,
            };
        }
    }

    // The element of a control, seen from outside.
    private static T Of<T>(Control control)
    {
        var outside = Wrappers.GetOrCreateComInterfaceForObject(Element(control), CreateComInterfaceFlags.None);
        try
        {
            return (T)Wrappers.GetOrCreateObjectForComInstance(outside, CreateObjectFlags.UniqueInstance);
        }
        finally
        {
            Marshal.Release(outside);
        }
    }

    private static Win32Element Element(Control control) => Win32Element.Of(
        ControlAutomationPeer.CreatePeerForElement(control), (PlatformWindow)TopLevel.GetTopLevel(control)!.PlatformImpl!);

    private static Task Shown(Action<Panel, Window, ScreenUser> test) => Drawing.Needed().RunAsync(() =>
    {
        var panel = new StackPanel
        {
            Children =
            {
                Named(new Button { Content = "OK" }, "Approve", "approve"),
                Named(new TextBox(), "Serial number", "serial"),
                Named(new TextBox { PasswordChar = '●' }, "Password", "secret"),
                Named(new CheckBox { Content = "Dark" }, "Dark", "dark"),
            }
        };
        AutomationProperties.SetName(panel, "All");
        var window = new Window { Width = 600, Height = 400, Content = panel };
        window.Show();
        try
        {
            test(panel, window, new ScreenUser(window).Settle());
        }
        finally
        {
            window.Close();
        }
    });

    private static Control Named(Control control, string name, string id)
    {
        AutomationProperties.SetName(control, name);
        AutomationProperties.SetAutomationId(control, id);
        return control;
    }
}
