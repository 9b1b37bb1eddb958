using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Names the blocks that <see cref="BoundarySearch"/> finds.</summary>
internal static class BlockProposal
{
    /// <summary>The blocks of boundaries, or why a boundary has none.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundaries">The features' boundaries, in their order.</param>
    /// <param name="toolDiameterMm">Diameter of the tool; null if unknown.</param>
    /// <param name="mapMm">Allowed distance of a key point from where it belongs.</param>
    public static IReadOnlyList<ProposedBlocks> Of(
        NcPath path, IReadOnlyList<SoughtBoundary> boundaries, double? toolDiameterMm, double mapMm) =>
        [.. BoundarySearch.Find(path, boundaries, toolDiameterMm, mapMm).Select((f, i) => Named(path, i, boundaries[i].Name, f))];

    private static ProposedBlocks Named(NcPath path, int feature, string name, FoundBoundary found)
    {
        var none = new ProposedBlocks(feature, name, []);
        if (found.Refusal is not null)
        {
            return none with { Refusal = found.Refusal };
        }

        var (names, passes) = (new List<string>(), new List<(int, int)>());
        foreach (var pass in found.Passes)
        {
            var (first, last) = (path.Motions[pass.First].Block, path.Motions[pass.Last].Block);
            if (last < first)
            {
                var block = path.Program[path.Motions[pass.First].Block];
                return none with
                {
                    Refusal = new(
                        BoundarySearch.NotFound,
                        $"{name}, {path.Program.NameOf(block)}: the program cuts this boundary by a jump or a call, so its blocks do not "
                            + $"follow one another in the file. Name the blocks yourself.",
                        new() { Feature = name, Block = path.Program.NameOf(block), Line = block.Line }),
                };
            }

            names.AddRange(BlockNames.Of(path.Program, first, last));
            passes.Add((first, last));
        }

        return none with { Blocks = [.. names.Distinct(StringComparer.Ordinal)], Passes = passes };
    }
}
