using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Report texts of judgements by a profile tolerance.</summary>
public static class ProfileWords
{
    /// <summary>The identifier of a result in JSON documents.</summary>
    public static string Of(ProfileCode code) => code switch
    {
        ProfileCode.Within => "within",
        ProfileCode.NotAccepted => "not-accepted",
        ProfileCode.OutsideBetween => "outside-between",
        _ => "outside",
    };

    /// <summary>The verdicts on a compensation that may be accepted, by their codes.</summary>
    public static IReadOnlyList<string> Acceptable { get; } =
        [.. Enum.GetValues<ProfileCode>().Where(c => c != ProfileCode.Within).Select(Of)];

    /// <summary>What becomes of a program by its verdict.</summary>
    /// <param name="verdict">The verdict; null if the job states no tolerance.</param>
    /// <param name="accepted">The codes that are accepted, or <see cref="Acceptance.Any"/>.</param>
    public static Acceptance Obey(SurfaceVerdict? verdict, IReadOnlyCollection<string> accepted) =>
        verdict is null ? Acceptance.None : Acceptance.Of(Of(verdict.Predicted.Code), verdict.IsToCut, accepted);

    /// <summary>The verdict on a compensation in words: what is expected, what was measured, and when not to cut.</summary>
    /// <param name="verdict">The verdict.</param>
    public static string Of(SurfaceVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        var (tolerance, predicted, before) = (verdict.Tolerance, verdict.Predicted, verdict.Before);
        var expected = $"profile {Size(predicted.ProfileMm)} of {Limit(tolerance.WidthMm)}";
        var chance = ReportNumber.Probability(predicted.Probability);
        return (predicted.Code switch
        {
            ProfileCode.Within => $"Expected in tolerance: {expected}, with a probability of {chance}.",
            ProfileCode.NotAccepted =>
                $"Not sure to be in tolerance: {expected} is expected, with a probability of {chance} that all points are inside; "
                    + $"{Percent(ProfileJudgement.LeastProbability(tolerance.Rule))} are wanted. "
                    + "Do not cut it unless you accept the risk.",
            ProfileCode.OutsideBetween =>
                $"Expected out of tolerance between the points: {Size(Math.Abs(predicted.WorstAnywhereMm ?? 0))} of "
                    + $"{Band(tolerance)}. "
                    + "Do not cut it unless that is acceptable there.",
            _ =>
                $"Expected out of tolerance: {expected}; {Outside(predicted, tolerance, "will be")}. "
                    + "Do not cut it unless that is acceptable there.",
        }) + $" As measured: {Short(before)}, profile {Size(before.ProfileMm)} µm.";
    }

    /// <summary>The result on pieces before compensation, in a few words.</summary>
    /// <param name="pieces">Their judgements, at least one.</param>
    public static string Before(IReadOnlyList<ProfileJudgement> pieces)
    {
        var worst = Worst(pieces);
        return $"Before: {Short(worst)}, profile {Size(worst.ProfileMm)} µm.";
    }

    /// <summary>The verdict on measured pieces in words.</summary>
    /// <param name="tolerance">The tolerance.</param>
    /// <param name="pieces">The pieces, at least one, each with the file of its points.</param>
    public static string Of(ProfileTolerance tolerance, IReadOnlyList<(string File, ProfileJudgement Judgement)> pieces)
    {
        ArgumentNullException.ThrowIfNull(tolerance);
        ArgumentNullException.ThrowIfNull(pieces);
        var worst = Worst([.. pieces.Select(p => p.Judgement)]);
        var file = pieces.First(p => p.Judgement == worst).File;
        var within = pieces.Count(p => p.Judgement.IsWithin);
        var head = Short(worst);
        var all = pieces.Count == 1 ? "" : within == pieces.Count
            ? $" all {ReportNumber.Count(pieces.Count)} pieces, {file} the worst with"
            : $" {ReportNumber.Count(pieces.Count - within)} of {ReportNumber.Count(pieces.Count)} pieces, {file} the worst with";
        var profile = $"profile {Size(worst.ProfileMm)} of {Limit(tolerance.WidthMm)}";
        return $"{char.ToUpperInvariant(head[0])}{head[1..]}:{all} {profile}" + worst.Code switch
        {
            ProfileCode.Within =>
                $" at {ReportNumber.Count(worst.Points, "point")}, with a probability of {ReportNumber.Probability(worst.Probability)}.",
            ProfileCode.NotAccepted =>
                $", but the guard band of {Limit(tolerance.Rule.GuardMm(worst.UncertaintyMm))} at each limit does not accept "
                    + $"{Points(worst.NotAccepted)}: too near the {(worst.NotAccepted.Count == 1 ? "limit" : "limits")}.",
            _ => $"; {Outside(worst, tolerance, "is", "are")}.",
        };
    }

    /// <summary>The tolerance and how it is applied, in a sentence.</summary>
    public static string Of(ProfileTolerance tolerance, double uncertaintyMm)
    {
        ArgumentNullException.ThrowIfNull(tolerance);
        return $"Profile of a surface {Limit(tolerance.WidthMm)} by ISO 1101, {(tolerance.IsAligned
            ? "without datums: points are aligned before they are judged"
            : "with datums: points are judged where they were measured")}; measured points are accepted "
            + (tolerance.Rule.RiskPercent is { } risk
                ? $"{Limit(tolerance.Rule.GuardMm(uncertaintyMm))} inside the limits, for a risk of at most "
                    + $"{ReportNumber.Short(risk)} % at each."
                : "up to the limits.");
    }

    private static ProfileJudgement Worst(IReadOnlyList<ProfileJudgement> pieces) =>
        pieces.OrderByDescending(j => j.Code).ThenByDescending(j => j.ProfileMm).First();

    private static string Short(ProfileJudgement judged) => judged.Code switch
    {
        ProfileCode.Within => "in tolerance",
        ProfileCode.NotAccepted => "not accepted",
        _ => "out of tolerance",
    };

    private static string Outside(ProfileJudgement judged, ProfileTolerance tolerance, string one, string? several = null) =>
        $"{ReportNumber.Count(judged.Outside.Count)} of {ReportNumber.Count(judged.Points, "point")} "
            + $"{(judged.Outside.Count == 1 ? one : several ?? one)} outside {Band(tolerance)}: {Points(judged.Outside)}"
            + (judged.Outside.Count == 1 ? "" : $", point {ReportNumber.Count(judged.WorstPoint)} the furthest")
            + $", by {Size(Math.Abs(judged.WorstMm) - tolerance.Limits.UpperMm)} µm";

    private static string Points(IReadOnlyList<int> points) =>
        (points.Count == 1 ? "point " : "points ") + ReportNames.Of([.. points.Select(ReportNumber.Count)]);

    private static string Band(ProfileTolerance tolerance) => "±" + Limit(tolerance.Limits.UpperMm);

    private static string Size(double mm) => (mm * 1000).ToString("0.00", CultureInfo.InvariantCulture);

    private static string Limit(double mm) => $"{ReportNumber.Short(Math.Round(mm * 1000, 3))} µm";

    private static string Percent(double share) => ReportNumber.Short(Math.Round(share * 100, 2)) + " %";
}
