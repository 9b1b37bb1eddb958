using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A line of two programs side by side.</summary>
/// <param name="Index">Its index in the list, from 0. Rewriting removes no line, so this is also its index in the new program.</param>
/// <param name="Block">Its index in the original, from 0; null if the line is inserted.</param>
/// <param name="Original">The original text; empty if the line is inserted.</param>
/// <param name="Modified">The new text.</param>
/// <param name="OriginalSpans">Replaced spans.</param>
/// <param name="ModifiedSpans">New spans.</param>
internal sealed record ProgramLine(
    int Index,
    int? Block,
    string Original,
    string Modified,
    IReadOnlyList<TextSpan> OriginalSpans,
    IReadOnlyList<TextSpan> ModifiedSpans)
{
    /// <summary>Its line number in the new program, from 1, as the control's screen counts.</summary>
    public string Number => Shown.Id(Index + 1);

    /// <summary>Its line number in the original, from 1; empty if the line is inserted.</summary>
    public string OriginalNumber => Block is { } block ? Shown.Id(block + 1) : "";

    /// <summary>True if the line is changed or inserted.</summary>
    public bool IsChanged => ModifiedSpans.Count > 0;
}
