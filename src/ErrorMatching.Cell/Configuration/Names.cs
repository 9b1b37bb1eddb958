using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Names that must differ, even for people who do not look at upper and lower case.</summary>
internal static class Names
{
    /// <summary>Refuses each name that stands before it already.</summary>
    /// <param name="items">The objects that have a name.</param>
    /// <param name="key">The key of the name.</param>
    /// <param name="code">Code of the problem.</param>
    /// <param name="what">What each is, for the sentence.</param>
    /// <param name="problems">Where to say so.</param>
    public static void RefuseTwins(IEnumerable<JsonItem> items, string key, string code, string what, CellProblems problems)
    {
        var seen = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        foreach (var name in items.Select(i => i.Find(key)).OfType<JsonItem>().Where(n => !seen.Add(n.Text)))
        {
            problems.Refuse(name, code, $"the {what} \"{name.Text}\" again", "one that no other has; upper and lower case are alike");
        }
    }

    /// <summary>How a sentence lists what there is.</summary>
    public static string Of(IEnumerable<string> names) => names.ToArray() is { Length: > 0 } all ? "one of " + string.Join(", ", all.Select(n => $"\"{n}\"")) : "none, for there is none";
}
