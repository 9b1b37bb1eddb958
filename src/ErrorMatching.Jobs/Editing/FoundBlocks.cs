using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The blocks that seem to cut the features of a job, to be checked before use.</summary>
/// <param name="Job">The job. Its features may lack their blocks.</param>
/// <param name="Program">Its program, as a path from the caller's folder.</param>
/// <param name="Path">The interpreted path.</param>
/// <param name="Features">For each feature, in the job's order, its blocks or why there are none.</param>
/// <param name="Read">The files that were read.</param>
/// <param name="JobBytes">The job's file.</param>
public sealed record FoundBlocks(
    MatingJob Job,
    string Program,
    NcPath Path,
    IReadOnlyList<ProposedBlocks> Features,
    IReadOnlyList<string> Read,
    ReadOnlyMemory<byte> JobBytes)
{
    /// <summary>Why features have no blocks; empty if each has some.</summary>
    public IReadOnlyList<Refusal> Refusals => InputRefusals.Of(Features.Select(f => f.Refusal).OfType<Refusal>(), Job.File, Program);

    /// <summary>True if the job already names the same cutting motions for a feature, in any form.</summary>
    /// <param name="feature">Index of the feature, from 0.</param>
    public bool IsInJob(int feature)
    {
        try
        {
            return Job.Features[feature].Blocks is { Count: > 0 } blocks
                && BlockSelector.Select(Path.Program, [.. blocks.Select(BlockSelector.Parse)]) is { IsUsable: true } named
                && Features[feature].Passes is { Count: > 0 } passes
                && Cutting(named.Result).SetEquals(Cutting(passes.SelectMany(p => Enumerable.Range(p.First, p.Last - p.First + 1))));
        }
        catch (InputException)
        {
            // Selectors that match nothing.
            return false;
        }
    }

    /// <summary>The job file with these blocks. All else stays, including comments and selectors that already name the same
    /// motions. UTF-8 without a byte order mark, with line feeds.</summary>
    /// <param name="target">Where it will be written: its relative paths are adapted to lead from there to the same files.</param>
    /// <exception cref="InvalidOperationException">A feature has no blocks.</exception>
    public byte[] JobAt(string target)
    {
        if (Refusals.Count > 0)
        {
            throw new InvalidOperationException("A feature without blocks makes no job.");
        }

        var text = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(JobBytes.Span).TrimStart('\uFEFF').ReplaceLineEndings("\n"));
        var root = JsonInput.Read(text, Job.File);
        return JsonEdit.Apply(text, [
            .. MovedPaths.Of(Job, root, target),
            .. root["features"].Items.SelectMany((f, i) => Blocks(f, i)),
            .. Hash(root["counterpart"])]);
    }

    // Lines are those of this program alone, and all blocks of the job were found in it or name what was found.
    private IEnumerable<JsonEdit> Hash(JsonItem counterpart)
    {
        var hasNewLines = Features.Index().Any(f => !IsInJob(f.Index) && f.Item.Blocks.Any(b => BlockSelector.Parse(b).IsByLine));
        var sha256 = DraftProgram.Of(Path.Program.Bytes).Sha256;
        if (counterpart.Find("programSha256") is { } stated)
        {
            if (!string.Equals(stated.Text, sha256, StringComparison.OrdinalIgnoreCase))
            {
                yield return new(stated.Bytes, JsonEdit.Text(sha256));
            }
        }
        else if (hasNewLines)
        {
            yield return new(After(counterpart["program"]), ", \"programSha256\": " + JsonEdit.Text(sha256));
        }
    }

    private static Range After(JsonItem item) => item.Bytes.End..item.Bytes.End;

    private HashSet<int> Cutting(IEnumerable<int> blocks) =>
        [.. blocks.SelectMany(b => Path.MotionsOf(b).ToArray()).Where(m => Path.Motions[m] is { IsCut: true, MovesInPlane: true })];

    private IEnumerable<JsonEdit> Blocks(JsonItem item, int feature)
    {
        if (!IsInJob(feature))
        {
            var list = JsonEdit.List(Features[feature].Blocks);
            yield return item.Find("blocks") is { } blocks
                ? new(blocks.Bytes, list)
                : new(After(item["points"]), ", \"blocks\": " + list);
        }
    }
}
