using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>The verdict on a counterpart that is cut and measured in the display language: the numbers, and in English the words, of the
/// report and the console.</summary>
internal static class VerifyVerdictText
{
    /// <summary>How many points are within their limits, which are not, and the risk that one truly is not.</summary>
    public static string Of(VerifyVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        var texts = Texts.Current;
        var result = verdict.Code switch
        {
            VerifyCode.NoLimits => texts.With("Piece.NoLimits", MatchVerdictText.Size(verdict.Worst), verdict.Worst.Point!),
            VerifyCode.Outside => Outside(verdict),
            _ when verdict.NotAccepted.Count > 0 => texts.Counted(
                "Pair.NotAccepted", verdict.NotAccepted.Count, Within(verdict, "Piece.Within"), VerdictParts.Names(verdict.NotAccepted)),
            _ => Within(verdict, "Piece.AllWithin"),
        };
        return Sentence.Joined(
            result, verdict.Probability is { } within ? texts.With("Piece.Risk", VerdictParts.Percent(1 - within)) : "");
    }

    /// <summary>Severity of a verdict. Without limits nobody but the user can judge.</summary>
    public static Severity SeverityOf(VerifyVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return verdict.Code == VerifyCode.Outside ? Severity.Alarm
            : verdict.IsInTolerance == true ? Severity.Quiet
            : Severity.Attention;
    }

    private static string Within(VerifyVerdict verdict, string key) => Texts.Current.With(
        key,
        Shown.Count(verdict.Within),
        Shown.Count(verdict.Points),
        Limits(verdict, verdict.Points),
        verdict is { Limits: null, Tightest: { } tightest }
            ? Texts.Current.With(
                "Pair.Tightest", MatchVerdictText.Size(tightest), MatchVerdictText.Band(tightest.Limits), tightest.Point!)
            : Texts.Current.With("Pair.WorstSize", MatchVerdictText.Size(verdict.Worst)));

    private static string Outside(VerifyVerdict verdict)
    {
        var (texts, count, furthest) = (Texts.Current, verdict.Outside.Count, verdict.Tightest!);
        var by = Shown.MmAsKnown(furthest.MarginMm, furthest.Interval95Mm);
        return texts.Counted(
            "Piece.Outside",
            count,
            Shown.Count(count),
            Shown.Count(verdict.Points),
            Limits(verdict, count),
            VerdictParts.Names(verdict.Outside),
            count == 1 ? texts.With("Pair.By", by) : texts.With("Pair.FurthestBy", furthest.Point!, by));
    }

    private static string Limits(VerifyVerdict verdict, int points) => verdict.Limits is { } limits
        ? Texts.Current.With("Pair.Limits", MatchVerdictText.Band(limits))
        : Texts.Current[points == 1 ? "Pair.OwnLimitsOne" : "Pair.OwnLimits"];
}
