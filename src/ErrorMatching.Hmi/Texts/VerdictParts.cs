namespace ErrorMatching.Hmi;

/// <summary>Parts that verdicts have in common, in the display language.</summary>
internal static class VerdictParts
{
    // More names than this would hide their number in a sentence; the tables mark all of them.
    private const int MostNamed = 6;

    /// <summary>A probability in percent.</summary>
    public static string Percent(double probability) => (probability * 100) switch
    {
        < 0.1 => Texts.Current["Pair.LeastPercent"],
        > 99.9 => Texts.Current["Pair.MostPercent"],
        var percent => Shown.FinePercent(percent),
    };

    /// <summary>Names in a sentence; of many, the first ones and the number of the others.</summary>
    public static string Names(IReadOnlyList<string> names) => names.Count switch
    {
        1 => names[0],
        <= MostNamed => Texts.Current.With("Pair.And", Texts.Current.Listed(names.SkipLast(1)), names[^1]),
        _ => Texts.Current.With("Pair.More", Texts.Current.Listed(names.Take(MostNamed)), Shown.Count(names.Count - MostNamed)),
    };
}
