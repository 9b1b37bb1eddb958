using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>The relative paths of a mating job that is written in another folder.</summary>
internal static class MovedPaths
{
    /// <summary>Edits after which a job's relative paths lead from its new place to the same files.</summary>
    /// <param name="job">The job.</param>
    /// <param name="root">Its document.</param>
    /// <param name="target">Where it will be written.</param>
    public static IEnumerable<JsonEdit> Of(MatingJob job, JsonItem root, string target)
    {
        var from = Path.GetDirectoryName(Path.GetFullPath(target))!;
        if (from == Path.GetDirectoryName(Path.GetFullPath(job.File)))
        {
            return [];
        }

        var (part, counterpart) = (root["part"], root["counterpart"]);
        return new[]
        {
            part["theoretical"], part["measured"], counterpart["program"], counterpart.Find("measured"),
            NcDialects.IsFile(job.Counterpart.Dialect) ? counterpart["dialect"] : null,
        }.OfType<JsonItem>().Concat(counterpart.Find("libraries")?.Items ?? [])
            .Where(p => !Path.IsPathRooted(p.Text))
            .Select(p => new JsonEdit(
                p.Bytes, JsonEdit.Text(Path.GetRelativePath(from, Path.GetFullPath(job.PathOf(p.Text))).Replace('\\', '/'))));
    }
}
