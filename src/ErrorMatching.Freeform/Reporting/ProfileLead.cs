using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What a setter reads first on a page about a surface: the verdict by the profile tolerance.</summary>
public static class ProfileLead
{
    private const string NotJudged = "Not judged: the job states no profile tolerance (profileToleranceMm).";

    /// <summary>The verdict on a compensation in one line.</summary>
    /// <param name="result">The compensation.</param>
    /// <param name="verdict">Its verdict; null if the job states no tolerance.</param>
    /// <param name="isReady">True if the program can be run as it is.</param>
    public static string Of(CompensationResult result, SurfaceVerdict? verdict, bool isReady = true)
    {
        ArgumentNullException.ThrowIfNull(result);
        return verdict is not null
            ? ProfileWords.Of(verdict)
                + (result.LargestMoveMm > 0 ? "" : " Nothing is compensated.")
                + (verdict.Predicted.IsWithin && isReady ? " Cut it." : "")
            : $"{NotJudged} Profile as measured {Micrometres.OfMm(result.Before.ProfileIsoMm)} µm, expected "
                + $"{Micrometres.OfMm(result.Predicted.Statistics.ProfileIsoMm)} µm.";
    }

    /// <summary>The verdict on measured pieces in one line.</summary>
    /// <param name="report">The report.</param>
    public static string Of(EvaluationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        if (report.Tolerance is not { } tolerance)
        {
            return report.Before is { } was
                ? $"{NotJudged} Profile before {Micrometres.OfMm(was.Together.ProfileIsoMm)} µm, now "
                    + $"{Micrometres.OfMm(report.Measured.Together.ProfileIsoMm)} µm."
                : $"{NotJudged} Profile {Micrometres.OfMm(report.Measured.Together.ProfileIsoMm)} µm.";
        }

        var now = ProfileWords.Of(tolerance, Judged(report.Measured));
        return report.Before is { } before
            ? $"{now} {ProfileWords.Before([.. before.Pieces.Select(p => p.Judgement!)])}"
            : now;
    }

    /// <summary>Writes the verdict on a compensation.</summary>
    /// <param name="html">The output.</param>
    /// <param name="result">The compensation.</param>
    /// <param name="verdict">Its verdict; null if the job states no tolerance.</param>
    /// <param name="isReady">True if the program can be run as it is.</param>
    /// <param name="acceptance">What became of the program.</param>
    internal static void Write(
        HtmlText html, CompensationResult result, SurfaceVerdict? verdict, bool isReady, Acceptance acceptance) =>
        Write(html, verdict?.IsToCut, isReady, Of(result, verdict, isReady), result.Warnings.Count, acceptance.Sentence);

    /// <summary>Writes the verdict on measured pieces.</summary>
    internal static void Write(HtmlText html, EvaluationReport report) =>
        Write(html, report.IsInTolerance, true, Of(report), report.Pieces.Sum(p => p.Warnings.Count));

    private static void Write(HtmlText html, bool? isWithin, bool isReady, string words, int warnings, string? more = null)
    {
        // A check mark on a program that stops with an alarm would suggest cutting.
        var (look, mark) = isWithin switch
        {
            true when isReady => ("verdict holds", "✓ "),
            false => ("verdict fails", "✗ "),
            _ => ("verdict", ""),
        };
        using (html.In("p", ("id", "verdict"), ("class", look)))
        {
            html.Put("strong", mark + words);
            if (more is not null)
            {
                html.Text($" {more} ");
            }

            if (warnings > 0)
            {
                html.Put(
                    "a",
                    warnings == 1 ? "Read the warning first." : $"Read the {ReportNumber.Count(warnings)} warnings first.",
                    ("href", "#summary"));
            }
        }
    }

    private static (string File, ProfileJudgement Judgement)[] Judged(SurfaceEvaluation evaluation) =>
        [.. evaluation.Pieces.Select(p => (p.File, p.Judgement!))];
}
