namespace ErrorMatching.Nc;

/// <summary>A displaced program: new bytes, and what was changed to get them.</summary>
/// <param name="Program">The new program.</param>
/// <param name="Patches">What was replaced in the original, in ascending order; everything else was copied.</param>
/// <param name="ChangedBlocks">Blocks with a changed or inserted word: positions, ascending.</param>
/// <param name="ChangedWords">Number of words that were changed or inserted.</param>
/// <param name="LeastIncrementMm">The increment that new coordinates were rounded to, mm.</param>
public sealed record Rewrite(
    NcProgram Program, IReadOnlyList<NcPatch> Patches, IReadOnlyList<int> ChangedBlocks, int ChangedWords, double LeastIncrementMm)
{
    /// <summary>The program as it is: nothing had to change.</summary>
    internal static Rewrite None(NcPath path) => new(path.Program, [], [], 0, Math.Pow(10, -path.Dialect.MetricDecimals));
}
