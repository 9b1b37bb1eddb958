using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Automation.Provider;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What a screen reader knows of a control that draws itself: what kind of thing it is, and what it says now.</summary>
/// <param name="owner">The control; its name is the view's.</param>
/// <param name="type">What kind of thing it is.</param>
/// <param name="said">What it says now: the values under the finger, the block that is lit; null for nothing.</param>
internal sealed class DrawnPeer(Control owner, AutomationControlType type, Func<string?> said) : ControlAutomationPeer(owner), IValueProvider
{
    /// <inheritdoc/>
    public bool IsReadOnly => true;

    /// <inheritdoc/>
    public string? Value => said();

    /// <summary>Says that <paramref name="owner"/> says something else now. Costs nothing while nobody listens.</summary>
    public static void Tell(Control owner, string? was, string? now)
    {
        if (was != now)
        {
            FromElement(owner)?.RaisePropertyChangedEvent(ValuePatternIdentifiers.ValueProperty, was, now);
        }
    }

    /// <inheritdoc/>
    public void SetValue(string? value) => throw new InvalidOperationException("What is drawn is not typed.");

    /// <inheritdoc/>
    protected override AutomationControlType GetAutomationControlTypeCore() => type;

    /// <inheritdoc/>
    protected override bool IsContentElementCore() => true;

    /// <inheritdoc/>
    protected override bool IsControlElementCore() => true;
}
