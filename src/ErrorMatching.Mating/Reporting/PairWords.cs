using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Report texts on a pair, assembled.</summary>
public static class PairWords
{
    /// <summary>Whether the pair goes together, how surely, and with how much air or overlap where.</summary>
    /// <param name="pair">The pair.</param>
    /// <param name="limits">The limits of the mating error, of each feature; null to leave them out.</param>
    public static string Of(PairAssembly pair, IReadOnlyList<ToleranceBand>? limits = null)
    {
        ArgumentNullException.ThrowIfNull(pair);
        var goesTogether = pair.Assembles || (limits is not null && pair.IsWithin(limits));
        return Together(pair, limits)
            + (goesTogether && pair.RoundCorners.Count > 0 ? $" {RoundCorners(pair.RoundCorners)}" : "")
            + (goesTogether && pair.DependsOnForms ? $" {UnknownForms(pair.UnknownForms)}" : "");
    }

    private static string UnknownForms(IReadOnlyList<string> features) =>
        $"It does so only if the form of {ReportNames.Of(features)} between the points is good enough: nothing is known of it.";

    private static string RoundCorners(IReadOnlyList<PairCorner> corners) =>
        $"It does so only if the part is rounded in the {(corners.Count == 1 ? "corner" : "corners")} of "
            + $"{ReportNames.Of([.. corners.Select(c => $"{c.Before}/{c.After}")])}: a sharp one would overlap there by "
            + $"{ReportNumber.Plain(corners.Max(c => c.OverlapMm))} mm.";

    private static string Together(PairAssembly pair, IReadOnlyList<ToleranceBand>? limits)
    {
        if (pair.TightestMm is not { } tightest)
        {
            return $"It goes together: the part can be lifted off. Pressed home, it rests on {Blocks(pair)}{LargestGap(pair)}.";
        }

        var half = pair.Interval95Mm is { } interval ? (interval.To - interval.From) / 2 : (double?)null;
        var probability = ReportNumber.Probability(pair.Probability);
        return (pair.Assembles, tightest < 0) switch
        {
            (true, _) => $"It goes together ({probability}), with {Size(Math.Max(0, tightest), half)} mm of air at the tightest "
                + $"{(BlocksOf(pair).Length == 1 ? "place" : "places")}, {Blocks(pair)}.",
            (false, true) when limits is not null && pair.IsWithin(limits) =>
                $"It goes together with pressure, which the limits allow ({probability} without): {Size(-tightest, half)} mm overlap at "
                    + $"{Blocks(pair)}.",
            (false, true) => $"It does not go together ({probability}): {Size(-tightest, half)} mm overlap at {Blocks(pair)}.",
            (false, false) => $"It does not go together ({probability}): no air is left at {Blocks(pair)}.",
        };
    }

    /// <summary>How far the part can move, in a sentence; null if it does not go together.</summary>
    public static string? Play(PairAssembly pair)
    {
        ArgumentNullException.ThrowIfNull(pair);
        return pair.Play is not { } play ? null
            : $"Play: x {Range(play.XMm, " mm")}, y {Range(play.YMm, " mm")}, turn {Range(play.TurnDeg, "°")}.";
    }

    private static string Range(PlayRange? range, string unit) =>
        range is not { } r ? PairPlay.Free : $"{ReportNumber.Signed(r.From)} to {ReportNumber.Signed(r.To)}{unit}";

    private static string LargestGap(PairAssembly pair) =>
        pair.Gaps.Count == 0 ? "" : $"; the largest gap left is {ReportNumber.Plain(pair.Gaps.Max(g => g.GapMm))} mm";

    private static string[] BlocksOf(PairAssembly pair) => [.. pair.Contacts.Select(c => c.Block).Distinct(StringComparer.Ordinal)];

    private static string Blocks(PairAssembly pair) => ReportNames.Of(BlocksOf(pair));

    // Two digits of the interval, as in the verdict.
    private static string Size(double mm, double? half)
    {
        var format = half is < 0.00995 ? "0.0000" : "0.000";
        return mm.ToString(format, CultureInfo.InvariantCulture)
            + (half is > 0 and var h ? " ± " + h.ToString(format, CultureInfo.InvariantCulture) : "");
    }
}
