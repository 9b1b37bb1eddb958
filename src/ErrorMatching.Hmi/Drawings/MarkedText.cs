using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Media;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A line of a program with the changed words marked by a background and by weight, not by color alone.</summary>
internal sealed class MarkedText : TextBlock
{
    public static readonly StyledProperty<string?> LineProperty = AvaloniaProperty.Register<MarkedText, string?>(nameof(Line));

    public static readonly StyledProperty<IReadOnlyList<TextSpan>?> SpansProperty =
        AvaloniaProperty.Register<MarkedText, IReadOnlyList<TextSpan>?>(nameof(Spans));

    public static readonly StyledProperty<IBrush?> MarkProperty = AvaloniaProperty.Register<MarkedText, IBrush?>(nameof(Mark));

    public string? Line
    {
        get => GetValue(LineProperty);
        set => SetValue(LineProperty, value);
    }

    /// <summary>The marked spans, as reports have them.</summary>
    public IReadOnlyList<TextSpan>? Spans
    {
        get => GetValue(SpansProperty);
        set => SetValue(SpansProperty, value);
    }

    /// <summary>Background of the marked spans.</summary>
    public IBrush? Mark
    {
        get => GetValue(MarkProperty);
        set => SetValue(MarkProperty, value);
    }

    internal IReadOnlyList<string> Marked =>
        Line is { } line && Spans is { } spans
            ? [.. spans.Where(s => s.Start + s.Length <= line.Length).Select(s => line.Substring(s.Start, s.Length))]
            : [];

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(TextBlock);

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new WholeLine(this);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == LineProperty || change.Property == SpansProperty || change.Property == MarkProperty)
        {
            Show();
        }
    }

    private void Show()
    {
        var (line, at) = (Line ?? "", 0);
        if (Spans is not { Count: > 0 } spans)
        {
            Inlines = null;
            Text = line;
            return;
        }

        var inlines = new InlineCollection();
        foreach (var (start, length) in spans.Where(s => s.Start >= at && s.Start + s.Length <= line.Length))
        {
            inlines.Add(new Run(line[at..start]));
            inlines.Add(
                new Run(line.Substring(start, length))
                {
                    Background = Mark,
                    FontWeight = FontWeight.Bold,
                    TextDecorations = Avalonia.Media.TextDecorations.Underline
                });
            at = start + length;
        }

        inlines.Add(new Run(line[at..]));
        Inlines = inlines;
    }

    /// <summary>Describes a line with marks to a screen reader: the whole line, and the marked words.</summary>
    private sealed class WholeLine(MarkedText owner) : TextBlockAutomationPeer(owner)
    {
        /// <inheritdoc/>
        protected override string? GetNameCore() => owner.Line;

        /// <inheritdoc/>
        protected override string? GetHelpTextCore() =>
            owner.Marked is { Count: > 0 } marked ? Texts.Current.With("Detail.ChangedWords", string.Join(", ", marked)) : null;
    }
}
