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
    public static Outcome<FoundBlocks> Of(string file, CancellationToken cancellation)
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
        var proposed = BlockProposal.Of(path, sought, job.Counterpart.ToolDiameterMm, job.Counterpart.MapMm);

        // Blocks that are found now are for the program as it is now.
        var now = job with { Counterpart = job.Counterpart with { ProgramSha256 = null } };
        return new FoundBlocks(job, program, path, [.. proposed.Select(p => Tried(now, path, theoretical, p))], files.Read, bytes);
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
