using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Errors in a configuration, and warnings about what is allowed but unwise.</summary>
internal sealed class CellProblems
{
    private readonly List<Refusal> _problems = [];
    private readonly List<Refusal> _warnings = [];

    /// <summary>Warnings, in document order.</summary>
    public IReadOnlyList<Refusal> Warnings => InOrder(_warnings);

    /// <summary>True if there is already an error at a path.</summary>
    public bool Has(string path) => _problems.Exists(p => p.Place.Path == path);

    public void AddRange(IEnumerable<Refusal> problems) => _problems.AddRange(problems.ToArray());

    public void Refuse(JsonItem item, string code, string found, string expected) =>
        _problems.Add(JsonRefusal.At(item, code, found, expected));

    public void Warn(JsonItem item, string code, string found, string expected) =>
        _warnings.Add(JsonRefusal.At(item, code, found, expected));

    /// <summary>Rejects texts with control characters, which no setter types: they would reach command lines and logs.</summary>
    public void RefuseControlCharacters(JsonItem item)
    {
        if (item.Text.Any(char.IsControl))
        {
            Refuse(item, "control-character", "text with a control character", "printable text");
        }

        foreach (var inside in item.Items.Concat(item.Members.Select(m => m.Value)))
        {
            RefuseControlCharacters(inside);
        }
    }

    /// <exception cref="InputException">There is at least one error.</exception>
    public void ThrowIfAny(string file)
    {
        if (_problems.Count > 0)
        {
            throw new InputException(file, InOrder(_problems));
        }
    }

    private static Refusal[] InOrder(IEnumerable<Refusal> problems) =>
        [.. problems.Distinct().OrderBy(p => p.Place.Line).ThenBy(p => p.Place.Column)];
}

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
