using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <content>
/// Blocks that run several times (loops, subprograms): every run must need the same new words, since the block can change only once.
/// </content>
internal sealed partial class WordEditor
{
    private Refusal? EditRepeated(List<int> affected)
    {
        var edits = new Dictionary<int, (int Place, NcPatch[] Patches)>();
        var blocks = new List<int>();
        foreach (var motion in affected)
        {
            var block = _path.Motions.BlockOf(motion);
            if (!edits.ContainsKey(block))
            {
                blocks.Add(block);
            }

            var runs = _path.MotionsOf(block).ToArray();
            for (var run = 0; run < runs.Length; run++)
            {
                if (edits.TryGetValue(block, out var known) && known.Place >= run)
                {
                    continue;
                }

                if (Edit(runs[run]) is { } refusal)
                {
                    return refusal;
                }

                var patches = _edit.Patches.ToArray();
                if (run > 0 && !Same(edits[block].Patches, patches))
                {
                    return BlockRefusal.At(
                        _path.Program, block, NcRefusalCodes.RunsDiffer,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"it runs {runs.Length} times, and would have to change differently at its run {run + 1} than at its first. "
                                + $"Displace all runs alike, or post the passes one after the other."));
                }

                edits[block] = (run, patches);
            }
        }

        foreach (var block in blocks.Order())
        {
            if (edits[block].Patches is { Length: > 0 } patches)
            {
                _patches.AddRange(patches);
                _changedBlocks.Add(block);
            }
        }

        return null;
    }

    private static bool Same(NcPatch[] a, NcPatch[] b)
    {
        var same = a.Length == b.Length;
        for (var i = 0; same && i < a.Length; i++)
        {
            same = a[i].Start == b[i].Start && a[i].Length == b[i].Length && a[i].Bytes.Span.SequenceEqual(b[i].Bytes.Span);
        }

        return same;
    }
}
