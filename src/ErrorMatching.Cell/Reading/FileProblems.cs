using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Problems in a file that a configuration names. They are reported at the key that names the file, with the file's own line,
/// column and path.</summary>
internal static class FileProblems
{
    /// <summary>Each problem of the file.</summary>
    public static IEnumerable<Refusal> Of(JsonItem item, IEnumerable<Refusal> problems) =>
        problems.Select(p => p with
        {
            Message = $"in {p.Sentence}",
            Place = JsonRefusal.PlaceOf(item),
        });

    /// <summary>Reports a file that cannot be read at all.</summary>
    public static Refusal Unreadable(JsonItem item, string code, string file, Exception why) => JsonRefusal.At(
        item,
        code,
        why is FileNotFoundException or DirectoryNotFoundException
            ? $"no file {file}"
            : $"the file {file}, which cannot be read: {why.Message.TrimEnd('.')}",
        "a file that is there and that this user may read");
}
