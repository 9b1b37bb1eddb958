namespace ErrorMatching.Hmi;

/// <summary>A line of two programs side by side.</summary>
/// <param name="Index">Its number in the list, from 0: as nothing is taken out of a program, its place in the new one.</param>
/// <param name="Block">Its place in the original, from 0; null if it is inserted.</param>
/// <param name="Original">The text in the original; empty if it is inserted.</param>
/// <param name="Modified">The text in the new program.</param>
/// <param name="OriginalSpans">What was replaced: start and length.</param>
/// <param name="ModifiedSpans">What stands there now: start and length.</param>
public sealed record ProgramLine(int Index, int? Block, string Original, string Modified, IReadOnlyList<(int Start, int Length)> OriginalSpans, IReadOnlyList<(int Start, int Length)> ModifiedSpans)
{
    /// <summary>Its line in the new program, from 1, as the screen of a control counts.</summary>
    public string Number => Shown.Id(Index + 1);

    /// <summary>Its line in the original, from 1; empty if it is inserted.</summary>
    public string OriginalNumber => Block is { } block ? Shown.Id(block + 1) : "";

    /// <summary>True if anything differs.</summary>
    public bool IsChanged => ModifiedSpans.Count > 0;
}
