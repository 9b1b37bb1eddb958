using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>The conditions of a refusal in a manual page.</summary>
internal static class RefusalText
{
    private static readonly (string Key, string Word)[] Conditions =
    [
        ("twoOf", "two of"), ("codes", ""), ("letters", ""), ("repeated", "twice"), ("missing", "without"), ("where", "with"),
        ("unless", "unless"), ("while", "while"), ("whileNot", "while not"), ("before", "after"), ("notYet", "before the first"),
        ("clears", "ends"),
        ("inForce", "in force: one of"), ("ends", "ended by"), ("atStart", "at first"),
    ];

    public static string Of(JsonItem entry)
    {
        if (entry.Find("accepted") is not null)
        {
            return "accepted";
        }

        // A group is nearly always the same as its codes that exclude each other.
        var isSame = entry.Find("twoOf")?.Text == entry.Find("inForce")?.Text;
        var parts = Conditions.Where(c => entry.Find(c.Key) is not null && !(isSame && c.Key == "inForce"))
            .Select(c => $"{c.Word} {entry[c.Key].Text}".Trim()).ToList();
        if (entry.Find("begins") is not null)
        {
            parts.Add("where it begins");
        }

        if (entry.Find("rises") is not null)
        {
            parts.Add("a cycle whose depth is above its R plane");
        }

        if (entry.Find("values") is { } values)
        {
            parts.Add($"other than {values.ToJson()}");
        }

        if (entry.Find("mostFunctions") is { } most)
        {
            parts.Add($"more than {most.ToJson()} M functions");
        }

        return string.Join(", ", parts);
    }
}
