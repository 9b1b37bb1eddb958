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

    /// <summary>Severity of a verdict. Without a tolerance nobody but the user can judge, and nothing asks for attention.</summary>
    public static Severity SeverityOf(SurfaceVerdict? verdict) => verdict?.Predicted.Code switch
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
            _ => texts.Counted(
                "Profile.Outside",
                judged.Outside.Count,
                profile,
                width,
                Shown.Count(judged.Outside.Count),
                Shown.Count(judged.Points),
                limit,
                VerdictParts.Names([.. judged.Outside.Select(p => Shown.Id(p))]),
                Shown.Id(judged.WorstPoint),
                Shown.Micrometers(Math.Abs(judged.WorstMm) - tolerance.Limits.UpperMm)),
        };
    }

    private static string Limit(double mm) => ReportNumber.Short(Math.Round(mm * 1000, 3));
}
