using Avalonia.Automation.Peers;

namespace ErrorMatching.Hmi;

/// <summary>What a screen reader knows of a line with marks: the whole line, and which words of it are marked.</summary>
/// <param name="owner">The line.</param>
internal sealed class MarkedTextPeer(MarkedText owner) : TextBlockAutomationPeer(owner)
{
    /// <inheritdoc/>
    protected override string? GetNameCore() => owner.Line;

    /// <inheritdoc/>
    protected override string? GetHelpTextCore() => owner.Marked is { Count: > 0 } marked ? Texts.Current.With("Detail.ChangedWords", string.Join(", ", marked)) : null;
}
