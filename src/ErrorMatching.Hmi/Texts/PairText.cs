using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>Whether two pieces go together, in the display language: the numbers, and in English the words, of the report and the
/// console.</summary>
internal static class PairText
{
    /// <summary>How surely they do, and with how much air or overlap where.</summary>
    /// <param name="pair">The pair.</param>
    /// <param name="limits">The limits of the mating error, of each feature.</param>
    public static string Of(PairAssembly pair, IEnumerable<ToleranceBand> limits)
    {
        ArgumentNullException.ThrowIfNull(pair);
        var sentence = Together(pair, limits);
        return pair.Assembles || pair.IsWithin(limits) ? Sentence.Joined(sentence, RoundCorners(pair), UnknownForms(pair)) : sentence;
    }

    private static string RoundCorners(PairAssembly pair) => pair.RoundCorners.Count == 0 ? "" : Texts.Current.Counted(
        "Pair.RoundCorners",
        pair.RoundCorners.Count,
        VerdictParts.Names([.. pair.RoundCorners.Select(c => $"{c.Before}/{c.After}")]),
        Shown.MmAsKnown(pair.RoundCorners.Max(c => c.OverlapMm), null));

    private static string UnknownForms(PairAssembly pair) =>
        pair.DependsOnForms ? Texts.Current.With("Pair.UnknownForms", VerdictParts.Names(pair.UnknownForms)) : "";

    /// <summary>The same for the head of a view, which has no room for what needs no decision: empty for a part that can be lifted off
    /// whatever its corners are.</summary>
    /// <param name="pair">The pair; null if nothing is known of one.</param>
    /// <param name="limits">The limits of the mating error, of each feature.</param>
    public static string Head(PairAssembly? pair, IEnumerable<ToleranceBand> limits) =>
        pair is null or { TightestMm: null, RoundCorners.Count: 0 } ? "" : Of(pair, limits);

    private static string Together(PairAssembly pair, IEnumerable<ToleranceBand> limits)
    {
        var texts = Texts.Current;
        string[] blocks = [.. pair.Contacts.Select(c => c.Block).Distinct(StringComparer.Ordinal)];
        var places = VerdictParts.Names(blocks);
        if (pair.TightestMm is not { } tightest)
        {
            return pair.Gaps.Count == 0
                ? texts.With("Pair.LiftsOffNoGap", places)
                : texts.With("Pair.LiftsOff", places, Shown.MmAsKnown(pair.Gaps.Max(g => g.GapMm), null));
        }

        var half = pair.Interval95Mm is { } interval ? (interval.To - interval.From) / 2 : (double?)null;
        var (probability, size) = (VerdictParts.Percent(pair.Probability), Shown.MmAsKnown(tightest, half));
        return (pair.Assembles, tightest < 0) switch
        {
            (true, false) => texts.Counted("Pair.Together", blocks.Length, probability, size, places),
            (true, true) => texts.Counted("Pair.Together", blocks.Length, probability, Shown.MmAsKnown(0, half), places),
            (false, true) when pair.IsWithin(limits) => texts.With("Pair.WithPressure", probability, size, places),
            (false, true) => texts.With("Pair.NotTogether", probability, size, places),
            (false, false) => texts.With("Pair.NoAir", probability, places),
        };
    }
}
