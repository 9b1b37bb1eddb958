using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Problems in a file that a configuration names. They are reported at the key that names the file, with the file's own line,
/// column and path.</summary>
internal static class FileProblems
{
    /// <summary>Each problem of the file.</summary>
    public static IEnumerable<JsonProblem> Of(JsonItem item, string file, IEnumerable<JsonProblem> problems) =>
        problems.Select(p => new JsonProblem(
        p.Code,
        item.Path,
        item.Place,
        p.Found,
        p.Expected,
        string.Create(CultureInfo.InvariantCulture, $"in {file}, line {p.Line}, column {p.Column}, {p.Path}: {p.Message}")));

    /// <summary>Reports a file that cannot be read at all.</summary>
    public static JsonProblem Unreadable(JsonItem item, string code, string file, Exception why) => JsonProblem.At(
        item,
        code,
        why is FileNotFoundException or DirectoryNotFoundException
            ? $"no file {file}"
            : $"the file {file}, which cannot be read: {why.Message.TrimEnd('.')}",
        "a file that is there and that this user may read");
}
