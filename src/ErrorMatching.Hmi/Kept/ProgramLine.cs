namespace ErrorMatching.Hmi;

/// <summary>A line of two programs side by side.</summary>
/// <param name="Index">Its number in the list, from 0.</param>
/// <param name="Original">The text in the original; empty if it is inserted.</param>
/// <param name="Modified">The text in the new program.</param>
/// <param name="OriginalSpans">What was replaced: start and length.</param>
/// <param name="ModifiedSpans">What stands there now: start and length.</param>
public sealed record ProgramLine(int Index, string Original, string Modified, IReadOnlyList<(int Start, int Length)> OriginalSpans, IReadOnlyList<(int Start, int Length)> ModifiedSpans)
{
    /// <summary>Its number on the screen, from 1.</summary>
    public string Number => Shown.Id(Index + 1);

    /// <summary>True if anything differs.</summary>
    public bool IsChanged => ModifiedSpans.Count > 0;
}
