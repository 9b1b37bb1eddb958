using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A displaced program and the changes that produced it.</summary>
/// <param name="Program">The new program.</param>
/// <param name="Patches">Replaced parts of the original, in ascending order; everything else was copied.</param>
/// <param name="ChangedBlocks">Blocks with a changed or inserted word: positions, ascending.</param>
/// <param name="ChangedWords">Number of changed or inserted words.</param>
/// <param name="LeastIncrementMm">The increment to which new coordinates were rounded, mm.</param>
public sealed record Rewrite(
    NcProgram Program, IReadOnlyList<NcPatch> Patches, IReadOnlyList<int> ChangedBlocks, int ChangedWords, double LeastIncrementMm)
{
    /// <summary>The unchanged program: nothing had to change.</summary>
    internal static Rewrite None(NcPath path) => new(path.Program, [], [], 0, Elementary.Pow(10, -path.Dialect.MetricDecimals));
}
