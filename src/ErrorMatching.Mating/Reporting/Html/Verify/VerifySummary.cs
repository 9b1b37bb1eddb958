using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section that shows at a glance whether the compensation helped. Against a counterpart as designed, which no machine cuts
/// exactly, nobody knows.</summary>
internal static class VerifySummary
{
    public static void Write(HtmlText html, VerifyReport report)
    {
        var (before, after) = (report.Result.MaxBeforeMm, report.Result.MaxAfterMm);
        if (report.IsBeforeMeasured)
        {
            WriteChange(html, report, before, after);
        }
        else
        {
            using (html.In("p", ("class", "verdict")))
            {
                html.Put("strong", $"○ The largest mating error is {ReportNumber.Plain(after)} mm.");
                html.Text(
                    $" Of the counterpart as designed it would be {ReportNumber.Plain(before)} mm; how much the compensation helped is not "
                        + "known.");
            }
        }

        ReportFacts.WriteWarnings(html, report.Warnings);
        ReportFacts.Write(html,
            (
                "Compared",
                $"{ReportNumber.Count(report.Result.Points.Count, "key point")} of "
                    + $"{(report.IsBeforeMeasured ? "two counterparts" : "the counterpart")} with the part, along the normals."),
            ("Worst before", Worst(report.Result.WorstBefore, p => p.BeforeError)),
            ("Worst after", Worst(report.Result.WorstAfter, p => p.AfterError)));
    }

    private static void WriteChange(HtmlText html, VerifyReport report, double before, double after)
    {
        // A check mark would suggest that a piece outside its limits is good.
        var isGood = report.Verdict.IsInTolerance != false;
        var (mark, words) = after < before ? (isGood ? "✓" : "○", "smaller") : after > before ? ("✗", "larger") : ("○", "the same");
        using (html.In("p", ("class", after >= before ? "verdict fails" : isGood ? "verdict holds" : "verdict")))
        {
            html.Put(
                "strong",
                $"{mark} The largest mating error is {words} with "
                    + $"compensation{(after < before ? "" : ". Find out why before the next piece")}.");
            html.Text($" Without: {ReportNumber.Plain(before)} mm. With: {ReportNumber.Plain(after)} mm.");
        }
    }

    private static string Worst(VerifiedPoint point, Func<VerifiedPoint, MatingError> error)
    {
        var normal = error(point).NormalMm;
        return $"{ReportNumber.SignedMm(normal)} at point {point.Label}, "
            + $"{(normal > 0 ? "an overlap" : normal < 0 ? "a gap" : "neither gap nor overlap")}.";
    }
}
