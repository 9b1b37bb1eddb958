using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Automation.Provider;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Describes a control that draws itself to a screen reader: its type and its current value.</summary>
/// <param name="owner">The control; its name is the view's.</param>
/// <param name="type">Its type.</param>
/// <param name="said">Its current value: the values under the finger, or the selected block; null if there is none.</param>
internal sealed class DrawnPeer(Control owner, AutomationControlType type, Func<string?> said) : ControlAutomationPeer(owner),
    IValueProvider
{
    /// <inheritdoc/>
    public bool IsReadOnly => true;

    /// <inheritdoc/>
    public string? Value => said();

    /// <summary>Reports a new value of <paramref name="owner"/>. Costs nothing if no screen reader listens.</summary>
    public static void Report(Control owner, string? was, string? now)
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
