using Avalonia.Automation.Peers;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Panel for rehearsing screens before the first sign-in: invisible, and hidden from screen readers and UI automation.</summary>
public sealed class Stage : Panel
{
    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new Closed(this);

    private sealed class Closed(Stage stage) : NoneAutomationPeer(stage)
    {
        /// <inheritdoc/>
        protected override IReadOnlyList<AutomationPeer>? GetChildrenCore() => null;
    }
}
