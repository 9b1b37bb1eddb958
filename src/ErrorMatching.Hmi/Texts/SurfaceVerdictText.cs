using ErrorMatching.Freeform;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The verdict on a surface in the display language: the numbers, and in English the words, of the report and the
/// console.</summary>
internal static class SurfaceVerdictText
{
    /// <summary>What is expected, what was measured, and whether to cut.</summary>
    /// <param name="findings">The report.</param>
    /// <param name="isToBeCut">False if cutting is no longer a question, or the program cannot be run as it is: then it is not
    /// recommended.</param>
    public static string Of(SurfaceFindings findings, bool isToBeCut)
    {
        ArgumentNullException.ThrowIfNull(findings);
        var texts = Texts.Current;
        if (findings.Verdict is not { } verdict)
        {
            return texts.With(
                "Profile.None",
                Shown.Micrometers(findings.Before.ProfileIsoMm),
                Shown.Micrometers(findings.Predicted.Statistics.ProfileIsoMm));
        }

        return Sentence.Joined(
            Expected(verdict.Tolerance, verdict.Predicted),
            verdict.Predicted.Code switch
            {
                ProfileCode.Within => "",
                ProfileCode.NotAccepted => texts["Pair.AcceptRisk"],
                _ => texts["Pair.AcceptThere"],
            },
            texts.With(
                "Profile.Before",
                texts[verdict.Before.Code switch
                {
                    ProfileCode.Within => "Profile.InTolerance",
                    ProfileCode.NotAccepted => "Profile.InGuardBand",
                    _ => "Profile.NotInTolerance",
                }],
                Shown.Micrometers(verdict.Before.ProfileMm)),
            findings.LargestMoveMm > 0 ? "" : texts["Profile.Unchanged"],
            isToBeCut && verdict.Predicted.IsWithin ? texts["Pair.Cut"] : "");
    }

    /// <summary>The verdict on a finished piece, as <c>surface evaluate</c> has it; null without a tolerance.</summary>
    /// <param name="verdict">The verdict.</param>
    public static string? OfPiece(SurfaceVerdict? verdict)
    {
        if (verdict is not { Tolerance: var tolerance, Before: var judged })
        {
            return null;
        }

        var (texts, profile, width) = (Texts.Current, Shown.Micrometers(judged.ProfileMm), Limit(tolerance.WidthMm));
        return judged.Code switch
        {
            ProfileCode.Within => texts.With(
                "Profile.PieceWithin", profile, width, Shown.Count(judged.Points), VerdictParts.Percent(judged.Probability)),
            ProfileCode.NotAccepted => texts.Counted(
                "Profile.PieceNotAccepted",
                judged.NotAccepted.Count,
                profile,
                width,
                Limit(tolerance.Rule.GuardMm(judged.UncertaintyMm)),
                VerdictParts.Names([.. judged.NotAccepted.Select(p => Shown.Id(p))])),
            _ => Outside("Profile.PieceOutside", tolerance, judged),
        };
    }

    /// <summary>The tolerance and how it is applied; null if the job states none.</summary>
    /// <param name="verdict">The verdict.</param>
    public static string? OfTolerance(SurfaceVerdict? verdict)
    {
        if (verdict is not { Tolerance: var tolerance, Before: var judged })
        {
            return null;
        }

        var texts = Texts.Current;
        return texts.With(
            tolerance.IsAligned ? "Profile.Aligned" : "Profile.WithDatums",
            Limit(tolerance.WidthMm),
            tolerance.Rule.RiskPercent is { } risk
                ? texts.With("Profile.Guarded", Limit(tolerance.Rule.GuardMm(judged.UncertaintyMm)), ReportNumber.Short(risk) + " %")
                : texts["Profile.Simple"]);
    }

    /// <summary>Severity of the verdict on a finished piece.</summary>
    /// <param name="verdict">The verdict; null if the job states no tolerance.</param>
    public static Severity SeverityOfPiece(SurfaceVerdict? verdict) => SeverityOf(verdict?.Before.Code);

    /// <summary>Severity of a verdict. Without a tolerance nobody but the user can judge, and nothing asks for attention.</summary>
    public static Severity SeverityOf(SurfaceVerdict? verdict) => SeverityOf(verdict?.Predicted.Code);

    private static Severity SeverityOf(ProfileCode? code) => code switch
    {
        null or ProfileCode.Within => Severity.Quiet,
        ProfileCode.Outside => Severity.Alarm,
        _ => Severity.Attention,
    };

    private static string Expected(ProfileTolerance tolerance, ProfileJudgement judged)
    {
        var (texts, profile, width, limit) = (
            Texts.Current, Shown.Micrometers(judged.ProfileMm), Limit(tolerance.WidthMm), Limit(tolerance.Limits.UpperMm));
        return judged.Code switch
        {
            ProfileCode.Within => texts.With("Profile.Within", profile, width, VerdictParts.Percent(judged.Probability)),
            ProfileCode.NotAccepted => texts.With(
                "Profile.NotAccepted",
                profile,
                width,
                VerdictParts.Percent(judged.Probability),
                ReportNumber.Short(Math.Round(100 * ProfileJudgement.LeastProbability(tolerance.Rule), 2)) + " %"),
            ProfileCode.OutsideBetween => texts.With(
                "Profile.OutsideBetween", Shown.Micrometers(Math.Abs(judged.WorstAnywhereMm ?? 0)), limit),
            _ => Outside("Profile.Outside", tolerance, judged),
        };
    }

    private static string Outside(string key, ProfileTolerance tolerance, ProfileJudgement judged) => Texts.Current.Counted(
        key,
        judged.Outside.Count,
        Shown.Micrometers(judged.ProfileMm),
        Limit(tolerance.WidthMm),
        Shown.Count(judged.Outside.Count),
        Shown.Count(judged.Points),
        Limit(tolerance.Limits.UpperMm),
        VerdictParts.Names([.. judged.Outside.Select(p => Shown.Id(p))]),
        Shown.Id(judged.WorstPoint),
        Shown.Micrometers(Math.Abs(judged.WorstMm) - tolerance.Limits.UpperMm));

    private static string Limit(double mm) => ReportNumber.Short(Math.Round(mm * 1000, 3));
}
