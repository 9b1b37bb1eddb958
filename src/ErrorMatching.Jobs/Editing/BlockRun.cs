using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds the blocks that seem to cut a job's features, by key points (<see cref="BoundarySearch"/>):
/// <c>errormatch job blocks</c>.</summary>
public static class BlockRun
{
    /// <summary>Searches for the blocks of all features, whether or not the job names some.</summary>
    /// <param name="file">The job's file. Its features may lack their blocks.</param>
    /// <param name="cancellation">Checked between reading and searching.</param>
    /// <returns>The result for each feature; a refusal if the program cannot be interpreted to its end.</returns>
    /// <exception cref="InputException">A file cannot be opened. The job cannot be used for a reason other than missing blocks. The
    /// nominal points cannot be used, or a key point is not among them. The job's own dialect cannot be used. The dialect or the
    /// program cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<FoundBlocks> Find(string file, CancellationToken cancellation)
    {
        var bytes = InputFile.Open(file, p => JsonInput.Load(p));
        var job = MatingJob.ParseWithoutBlocks(bytes, file);
        var files = new JobFiles(job);
        var theoretical = files.Theoretical();
        theoretical.Require(job.KeyPoints);
        var interpreted = files.Interpret(cancellation);
        var (program, path) = (interpreted.File, interpreted.Path);
        if (path.Refusal is { } refusal)
        {
            return refusal.In(program);
        }

        var sought = job.Features.Select(f => Sought(job, f, theoretical)).ToArray();
        var proposed = BlockProposal.Propose(path, sought, job.Counterpart.ToolDiameterMm, job.Counterpart.MapMm);

        // Blocks that are found now are for the program as it is now.
        var now = job with { Counterpart = job.Counterpart with { ProgramSha256 = null } };
        return new FoundBlocks(job, program, path, [.. proposed.Select(p => Tried(now, path, theoretical, p))], files.Opened, bytes);
    }

    private static SoughtBoundary Sought(MatingJob job, JobFeature feature, MeasurementFile theoretical) =>
        new(
            feature.Name,
            feature.Plane,
            [.. feature.Points.Select(p => (p, job.Counterpart.PlaceOf(theoretical[p], feature.Plane, theoretical.File)))])
        {
            Kind = feature.Kind,
        };

    // Do not propose what a match would refuse.
    private static ProposedBlocks Tried(MatingJob job, NcPath path, MeasurementFile theoretical, ProposedBlocks proposed)
    {
        if (proposed.Blocks.Count == 0 || BoundarySearch.Try(job, path, theoretical, proposed.Feature, proposed.Blocks) is not { } refusal)
        {
            return proposed;
        }

        var why = $"{refusal.Message} A match refuses {string.Join(", ", proposed.Blocks)}: name the blocks yourself.";
        return new(proposed.Feature, proposed.Name, []) { Refusal = refusal with { Message = why } };
    }
}

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

/// <summary>Blocks that seem to cut a feature, to be checked before use.</summary>
/// <param name="Feature">Index of the feature in the job or draft, from 0.</param>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors of the blocks; empty if they were not found.</param>
public sealed record ProposedBlocks(int Feature, string Name, IReadOnlyList<string> Blocks)
{
    /// <summary>The first and last block of each pass, as positions in the program; empty if they were not found.</summary>
    public IReadOnlyList<(int First, int Last)> Passes { get; init; } = [];

    /// <summary>Why they were not found, or null.</summary>
    public Refusal? Refusal { get; init; }
}

/// <summary>Names the blocks that <see cref="BoundarySearch"/> finds.</summary>
internal static class BlockProposal
{
    /// <summary>The blocks of boundaries, or why a boundary has none.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundaries">The features' boundaries, in their order.</param>
    /// <param name="toolDiameterMm">Diameter of the tool; null if unknown.</param>
    /// <param name="mapMm">Allowed distance of a key point from where it belongs.</param>
    public static IReadOnlyList<ProposedBlocks> Propose(
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
