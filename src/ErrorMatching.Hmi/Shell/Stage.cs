using Avalonia.Automation.Peers;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where screens are rehearsed before anybody has signed in: neither seen nor, by whatever reads screens out or drives them, found.</summary>
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
