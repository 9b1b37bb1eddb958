using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Checks that names differ by more than case.</summary>
internal static class Names
{
    /// <summary>Rejects each name that occurred earlier.</summary>
    /// <param name="items">The objects that have names.</param>
    /// <param name="key">The key that holds the name.</param>
    /// <param name="code">Code of the problem.</param>
    /// <param name="what">What each object is, for the message.</param>
    /// <param name="problems">Receives the problems.</param>
    public static void RefuseTwins(IEnumerable<JsonItem> items, string key, string code, string what, CellProblems problems)
    {
        var seen = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        foreach (var name in items.Select(i => i.Find(key)).OfType<JsonItem>().Where(n => !seen.Add(n.Text)))
        {
            problems.Refuse(name, code, $"the {what} \"{name.Text}\" again", "one that no other has; upper and lower case are alike");
        }
    }

    /// <summary>Lists the existing names for a message.</summary>
    public static string Of(IEnumerable<string> names) =>
        names.ToArray() is { Length: > 0 } all ? "one of " + string.Join(", ", all.Select(n => $"\"{n}\"")) : "none, for there is none";
}
