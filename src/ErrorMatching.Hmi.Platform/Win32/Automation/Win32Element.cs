using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.InteropServices.Marshalling;
using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Automation.Provider;
using Avalonia.Controls;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>What a screen reader learns of one control, from the control's automation peer. It is asked on threads of the system, and
/// answers on the UI thread.</summary>
[GeneratedComClass]
internal sealed partial class Win32Element : IElementProvider, IFragmentProvider, IFragmentRootProvider, IInvoked, IValued, IToggled,
    IExpanded, ISelected, IBroughtIntoView
{
    // UIA_E_...
    private const int NotAvailable = unchecked((int)0x80040201), NotEnabled = unchecked((int)0x80040200);

    // E_INVALIDARG.
    private const int Invalid = unchecked((int)0x80070057);

    // ProviderOptions_ServerSideProvider; UiaAppendRuntimeId.
    private const int InThisProcess = 2, BelowWindow = 3;
    private static readonly ConditionalWeakTable<AutomationPeer, Win32Element> Known = [];
    private static int _last;
    private readonly int _number = Interlocked.Increment(ref _last);
    private readonly AutomationPeer _peer;
    private readonly PlatformWindow _window;

    private Win32Element(AutomationPeer peer, PlatformWindow window) => (_peer, _window) = (peer, window);

    private bool IsPassword => _peer is ControlAutomationPeer { Owner: TextBox { PasswordChar: not '\0' } };

    private AutomationPeer? Container => _peer.GetProvider<ISelectionItemProvider>()?.SelectionContainer as AutomationPeer;

    // The list of a box that opens is shown apart from it, and enabled by itself.
    private bool CanAct => _peer.IsEnabled() && !_peer.IsOffscreen() && Container?.IsEnabled() != false;

    private bool IsRoot => _peer.GetProvider<IRootProvider>() is not null;

    /// <summary>The element of a peer: always the same one.</summary>
    [return: System.Diagnostics.CodeAnalysis.NotNullIfNotNull(nameof(peer))]
    public static Win32Element? Of(AutomationPeer? peer, PlatformWindow window) =>
        peer is null ? null : Known.GetValue(peer, p => new(p, window));

    /// <summary>The element that has the focus.</summary>
    public static Win32Element? Focused(IRootProvider? root, PlatformWindow window) => Of(Nearest(root?.GetFocus()), window);

    public int GetOptions() => InThisProcess;

    public IElementProvider? GetHost() => On(() =>
    {
        IElementProvider? host = null;
        if (IsRoot && _window is Win32Window { Window: var window })
        {
            Marshal.ThrowExceptionForHR(Uia.GetHost(window, out host));
        }

        return host;
    });

    public IElementProvider? GetPattern(int pattern) => On(() => pattern switch
    {
        Uia.Invoke => Can<IInvokeProvider>(),
        Uia.Value => Can<IValueProvider>(),
        Uia.Toggle => Can<IToggleProvider>(),
        Uia.ExpandCollapse => Can<IExpandCollapseProvider>(),
        Uia.SelectionItem => Can<ISelectionItemProvider>(),
        Uia.ScrollItem => !IsRoot,
        _ => false,
    }) ? this : null;

    public unsafe void GetProperty(int property, ComVariant* value) => *value = On(() => property switch
    {
        Uia.ProcessId => ComVariant.Create(Environment.ProcessId),
        Uia.ControlType => ComVariant.Create(UiaRole.Of(_peer.GetAutomationControlType())),
        Uia.Name => Text(_peer.GetName()),
        Uia.Help => Text(_peer.GetHelpText()),
        Uia.Id => Text(_peer.GetAutomationId()),
        Uia.ClassName => Text(_peer.GetClassName()),
        Uia.ItemStatus => Text(_peer.GetItemStatus()),
        Uia.Framework => Text("Avalonia"),
        Uia.HasFocus => ComVariant.Create(_peer.HasKeyboardFocus()),
        Uia.IsFocusable => ComVariant.Create(_peer.IsKeyboardFocusable()),
        Uia.IsEnabled => ComVariant.Create(_peer.IsEnabled()),
        Uia.IsControl => ComVariant.Create(_peer.IsControlElement()),
        Uia.IsContent => ComVariant.Create(_peer.IsContentElement()),
        Uia.IsOffscreen => ComVariant.Create(_peer.IsOffscreen()),
        Uia.IsPassword => ComVariant.Create(IsPassword),
        _ => default,
    });

    public IFragmentProvider? Navigate(int direction) => On<IFragmentProvider?>(() =>
    {
        const int parent = 0, next = 1, previous = 2, first = 3, last = 4;
        return Of(
            direction switch
            {
                parent => Around(_peer),
                next when Around(_peer) is { } around => Below(around).SkipWhile(p => !ReferenceEquals(p, _peer)).ElementAtOrDefault(1),
                previous when Around(_peer) is { } around => Below(around).TakeWhile(p => !ReferenceEquals(p, _peer)).LastOrDefault(),
                first => Below(_peer).FirstOrDefault(),
                last => Below(_peer).LastOrDefault(),
                _ => null,
            },
            _window);
    });

    public nint GetRuntimeId() => On(() => IsRoot ? 0 : Uia.Array([BelowWindow, _number]));

    public ScreenRectangle GetBounds() => On(() =>
    {
        if (IsRoot)
        {
            return default;
        }

        var bounds = _peer.GetBoundingRectangle();
        var (from, to) = (_window.PointToScreen(bounds.TopLeft), _window.PointToScreen(bounds.BottomRight));
        return new ScreenRectangle { Left = from.X, Top = from.Y, Width = to.X - from.X, Height = to.Y - from.Y };
    });

    public nint GetEmbeddedRoots() => 0;

    public void SetFocus() => On(_peer.SetFocus);

    public IFragmentRootProvider GetRoot() => On(() => Of(IsRoot ? _peer : _peer.GetVisualRoot()!, _window));

    public IFragmentProvider? GetElementAt(double x, double y) => On<IFragmentProvider?>(() =>
    {
        var at = _window.PointToClient(new PixelPoint((int)Math.Floor(x), (int)Math.Floor(y)));
        return Of(Nearest(_peer.GetProvider<IRootProvider>()?.GetPeerFromPoint(at)), _window);
    });

    public IFragmentProvider? GetFocused() => On<IFragmentProvider?>(() => Focused(_peer.GetProvider<IRootProvider>(), _window));

    public void Invoke() => Act<IInvokeProvider>(p => p.Invoke());

    public void SetValue(string value) => On(() =>
    {
        var text = Do<IValueProvider>();
        if (!CanAct || text.IsReadOnly)
        {
            throw Refused(NotEnabled);
        }

        if (_peer is ControlAutomationPeer { Owner: TextBox { MaxLength: > 0 and var most } } && value.Length > most)
        {
            throw Refused(Invalid);
        }

        text.SetValue(value);
    });

    // What a password is, nobody is told.
    public string GetValue() => On(() => IsPassword ? "" : Do<IValueProvider>().Value ?? "");

    public int GetIsReadOnly() => On(() => Number(Do<IValueProvider>().IsReadOnly));

    public void Toggle() => Act<IToggleProvider>(p => p.Toggle());

    int IToggled.GetState() => On(() => (int)Do<IToggleProvider>().ToggleState);

    public void Expand() => Act<IExpandCollapseProvider>(p => p.Expand());

    public void Collapse() => Act<IExpandCollapseProvider>(p => p.Collapse());

    int IExpanded.GetState() => On(() => UiaRole.Of(Do<IExpandCollapseProvider>().ExpandCollapseState));

    public void Select() => Act<ISelectionItemProvider>(p => p.Select());

    public void Add() => Act<ISelectionItemProvider>(p => p.AddToSelection());

    public void Remove() => Act<ISelectionItemProvider>(p => p.RemoveFromSelection());

    public int GetIsSelected() => On(() => Number(Do<ISelectionItemProvider>().IsSelected));

    public IElementProvider? GetContainer() => On<IElementProvider?>(() => Of(Container, _window));

    public void BringIntoView() => On(_peer.BringIntoView);

    private static int Number(bool value) => value ? 1 : 0;

    private static ComVariant Text(string? text) => ComVariant.Create(text ?? "");

    // A part of a control, such as the frame of a button, is none of its own: what is in it counts as in the control.
    private static IEnumerable<AutomationPeer> Below(AutomationPeer peer) =>
        peer.GetChildren().SelectMany(p => p.IsControlElement() ? [p] : Below(p));

    private static AutomationPeer? Around(AutomationPeer peer) => Nearest(peer.GetParent());

    private static AutomationPeer? Nearest(AutomationPeer? peer)
    {
        while (peer?.IsControlElement() == false)
        {
            peer = peer.GetParent();
        }

        return peer;
    }

    // Without what the thread was told of another error.
    private static Exception Refused(int code) => Marshal.GetExceptionForHR(code, -1)!;

    private bool Can<T>() => _peer.GetProvider<T>() is not null;

    private T Do<T>() => _peer.GetProvider<T>() ?? throw new InvalidOperationException("The control cannot do this.");

    // Only what somebody at the screen could do now. It is done afterwards, as another input: the other program does not wait for it, and
    // an error in it is an error of the station.
    private void Act<T>(Action<T> act) => On(() =>
    {
        var provider = Do<T>();
        if (!CanAct)
        {
            throw Refused(NotEnabled);
        }

        Dispatcher.UIThread.Post(
            () =>
            {
                if (CanAct)
                {
                    act(provider);
                }
            },
            DispatcherPriority.Input);
    });

    private void On(Action act) => _ = On(() =>
    {
        act();
        return true;
    });

    private T On<T>(Func<T> answer)
    {
        try
        {
            // Before all else: the other program waits, and the station's own input may never pause.
            return Dispatcher.UIThread.CheckAccess() ? Answer() : Dispatcher.UIThread.Invoke(Answer, DispatcherPriority.Send);
        }
        catch (OperationCanceledException)
        {
            throw Refused(NotAvailable);
        }

        // A control that is no longer shown, such as that of a screen before somebody signed out, answers nothing any more.
        T Answer() => _window is Win32Window { Window: 0 } || (!IsRoot && _peer.GetVisualRoot() is null)
            ? throw Refused(NotAvailable)
            : answer();
    }
}
