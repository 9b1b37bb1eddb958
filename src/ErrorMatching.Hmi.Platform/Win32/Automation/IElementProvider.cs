using System.Runtime.InteropServices;
using System.Runtime.InteropServices.Marshalling;

namespace ErrorMatching.Hmi.Platform;

// The interfaces by which UI Automation asks a program what it shows, as UIAutomationCore.idl has them: the order of their members and
// their identifiers are what counts. Only those that a station has an answer for.

/// <summary>IRawElementProviderSimple: what an element is, and what can be done with it.</summary>
[GeneratedComInterface]
[Guid("d6dd68d1-86fd-4332-8666-9abedea2d24c")]
internal unsafe partial interface IElementProvider
{
    int GetOptions();

    IElementProvider? GetPattern(int pattern);

    void GetProperty(int property, ComVariant* value);

    IElementProvider? GetHost();
}

/// <summary>IRawElementProviderFragment: where an element is among others.</summary>
[GeneratedComInterface]
[Guid("f7063da8-8359-439c-9297-bbc5299a7d87")]
internal partial interface IFragmentProvider
{
    IFragmentProvider? Navigate(int direction);

    /// <returns>A SAFEARRAY that the caller frees; 0 for a window.</returns>
    nint GetRuntimeId();

    ScreenRectangle GetBounds();

    /// <returns>A SAFEARRAY that the caller frees; 0 for none.</returns>
    nint GetEmbeddedRoots();

    void SetFocus();

    IFragmentRootProvider GetRoot();
}

/// <summary>IRawElementProviderFragmentRoot: a window.</summary>
[GeneratedComInterface]
[Guid("620ce2a5-ab8f-40a9-86cb-de3c75599b58")]
internal partial interface IFragmentRootProvider
{
    IFragmentProvider? GetElementAt(double x, double y);

    IFragmentProvider? GetFocused();
}

/// <summary>IInvokeProvider: what acts when it is pressed.</summary>
[GeneratedComInterface]
[Guid("54fcb24b-e18e-47a2-b4d3-eccbe77599a2")]
internal partial interface IInvoked
{
    void Invoke();
}

/// <summary>IValueProvider: what has a text.</summary>
[GeneratedComInterface]
[Guid("c7935180-6fb3-4201-b174-7df73adbf64a")]
internal partial interface IValued
{
    void SetValue([MarshalAs(UnmanagedType.LPWStr)] string value);

    [return: MarshalAs(UnmanagedType.BStr)]
    string GetValue();

    int GetIsReadOnly();
}

/// <summary>IToggleProvider: what is on or off.</summary>
[GeneratedComInterface]
[Guid("56d00bd0-c4f4-433c-a836-1a52a57e0892")]
internal partial interface IToggled
{
    void Toggle();

    int GetState();
}

/// <summary>IExpandCollapseProvider: what opens.</summary>
[GeneratedComInterface]
[Guid("d847d3a5-cab0-4a98-8c32-ecb45c59ad24")]
internal partial interface IExpanded
{
    void Expand();

    void Collapse();

    int GetState();
}

/// <summary>ISelectionItemProvider: one of several.</summary>
[GeneratedComInterface]
[Guid("2acad808-b2d4-452d-a407-91ff1ad167b2")]
internal partial interface ISelected
{
    void Select();

    void Add();

    void Remove();

    int GetIsSelected();

    IElementProvider? GetContainer();
}

/// <summary>IScrollItemProvider: what can be brought into view.</summary>
[GeneratedComInterface]
[Guid("2360c714-4bf1-4b26-ba65-9b21316127eb")]
internal partial interface IBroughtIntoView
{
    void BringIntoView();
}

/// <summary>UiaRect, in pixels of the screen.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ScreenRectangle
{
    public double Left, Top, Width, Height;
}
