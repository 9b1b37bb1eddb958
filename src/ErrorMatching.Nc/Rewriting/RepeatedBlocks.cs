using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Edits blocks that run several times (loops, subprograms): every run must need the same new words, since the block can change
/// only once.</summary>
internal sealed class RepeatedBlocks(NcPath path, MotionWords words)
{
    /// <summary>Edits the blocks of motions.</summary>
    /// <param name="affected">The motions.</param>
    /// <param name="patches">Receives the patches of all blocks.</param>
    /// <returns>The reason why a block cannot change, or null.</returns>
    public Refusal? Edit(List<int> affected, BlockPatches patches)
    {
        var edits = new Dictionary<int, (int Place, NcPatch[] Patches)>();
        var blocks = new List<int>();
        foreach (var motion in affected)
        {
            var block = path.Motions.BlockOf(motion);
            if (!edits.ContainsKey(block))
            {
                blocks.Add(block);
            }

            var runs = path.MotionsOf(block).ToArray();
            for (var run = 0; run < runs.Length; run++)
            {
                if (edits.TryGetValue(block, out var known) && known.Place >= run)
                {
                    continue;
                }

                if (words.Edit(runs[run]) is { } refusal)
                {
                    return refusal;
                }

                var edited = words.Patches.ToArray();
                if (run > 0 && !Same(edits[block].Patches, edited))
                {
                    return BlockRefusal.At(
                        path.Program, block, NcRefusalCodes.RunsDiffer,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"it runs {runs.Length} times, and would have to change differently at its run {run + 1} than at its first. "
                                + $"Displace all runs alike, or post the passes one after the other."));
                }

                edits[block] = (run, edited);
            }
        }

        foreach (var block in blocks.Order())
        {
            patches.Add(block, edits[block].Patches);
        }

        return null;
    }

    /// <summary>True if two blocks' patches are the same.</summary>
    public static bool Same(NcPatch[] a, NcPatch[] b)
    {
        var same = a.Length == b.Length;
        for (var i = 0; same && i < a.Length; i++)
        {
            same = a[i].Start == b[i].Start && a[i].Length == b[i].Length && a[i].Bytes.Span.SequenceEqual(b[i].Bytes.Span);
        }

        return same;
    }
}
