using Avalonia.Automation.Peers;

namespace ErrorMatching.Hmi;

/// <summary>Describes a line with marks to a screen reader: the whole line, and the marked words.</summary>
/// <param name="owner">The line.</param>
internal sealed class MarkedTextPeer(MarkedText owner) : TextBlockAutomationPeer(owner)
{
    /// <inheritdoc/>
    protected override string? GetNameCore() => owner.Line;

    /// <inheritdoc/>
    protected override string? GetHelpTextCore() =>
        owner.Marked is { Count: > 0 } marked ? Texts.Current.With("Detail.ChangedWords", string.Join(", ", marked)) : null;
}
