using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>A change to a JSON document that keeps all other bytes.</summary>
/// <param name="At">The bytes to replace.</param>
/// <param name="With">The replacement.</param>
internal sealed record JsonEdit(Range At, string With)
{
    /// <summary>Applies edits that do not overlap.</summary>
    public static byte[] Apply(ReadOnlySpan<byte> document, IEnumerable<JsonEdit> edits)
    {
        using var changed = new MemoryStream();
        var at = 0;
        foreach (var edit in edits.OrderBy(e => e.At.Start.Value))
        {
            changed.Write(document[at..edit.At.Start.Value]);
            changed.Write(Encoding.UTF8.GetBytes(edit.With));
            at = edit.At.End.Value;
        }

        changed.Write(document[at..]);
        return changed.ToArray();
    }

    /// <summary>A text as JSON.</summary>
    public static string Text(string text) => $"\"{JsonEncodedText.Encode(text, JavaScriptEncoder.UnsafeRelaxedJsonEscaping)}\"";

    /// <summary>A list of texts as JSON.</summary>
    public static string List(IEnumerable<string> texts) => "[" + string.Join(", ", texts.Select(Text)) + "]";
}

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
