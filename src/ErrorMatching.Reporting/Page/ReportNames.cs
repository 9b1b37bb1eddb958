namespace ErrorMatching.Reporting;

/// <summary>Lists names in a sentence.</summary>
public static class ReportNames
{
    // More names than this would hide their number in a sentence; the tables mark all of them.
    private const int Most = 6;

    /// <summary>The names with commas and <c>and</c>; of many, the first ones and the number of the others.</summary>
    /// <param name="names">At least one name.</param>
    public static string Of(IReadOnlyList<string> names)
    {
        ArgumentNullException.ThrowIfNull(names);
        return names.Count switch
        {
            1 => names[0],
            <= Most => $"{string.Join(", ", names.SkipLast(1))} and {names[^1]}",
            _ => $"{string.Join(", ", names.Take(Most))} and {ReportNumber.Count(names.Count - Most)} more",
        };
    }
}
