using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Shows the changes of a rewrite block by block, with the changed words marked.</summary>
internal static class BlockComparison
{
    /// <summary>The changed blocks, in the order of the program.</summary>
    /// <param name="before">The original program.</param>
    /// <param name="rewrite">The changes.</param>
    public static IReadOnlyList<ReportBlock> Of(NcProgram before, Rewrite rewrite)
    {
        var blocks = new List<ReportBlock>();
        var next = 0;
        foreach (var index in rewrite.ChangedBlocks.Order())
        {
            var block = before[index];
            var (was, now) = (new List<TextSpan>(), new List<TextSpan>());
            var shift = 0;
            for (; next < rewrite.Patches.Count && rewrite.Patches[next].Start <= block.End; next++)
            {
                var patch = rewrite.Patches[next];
                var start = patch.Start - block.Start;
                was.Add(new(start, patch.Length));
                now.Add(new(start + shift, patch.Bytes.Length));
                shift += patch.Bytes.Length - patch.Length;
            }

            var modified = rewrite.Program[index];
            blocks.Add(new(
                before.NumberOf(block),
                block.Line,
                CharacterPerByte(before, block),
                CharacterPerByte(rewrite.Program, modified),
                was,
                now));
        }

        return blocks;
    }

    // One character per byte, so that spans match in both; comments in other encodings show their bytes.
    private static string CharacterPerByte(NcProgram program, NcBlock block) =>
        System.Text.Encoding.Latin1.GetString(program.BytesOf(block));
}
