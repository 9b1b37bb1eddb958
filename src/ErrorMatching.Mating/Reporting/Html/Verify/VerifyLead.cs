using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What everybody reads first on the page of a verification: the verdict by the limits, and its risk.</summary>
internal static class VerifyLead
{
    public static void Write(HtmlText html, VerifyReport report)
    {
        var verdict = report.Verdict;
        var (look, mark) = verdict.IsInTolerance switch
        {
            true => ("verdict holds", "✓ "),
            false => ("verdict fails", "✗ "),
            null => ("verdict", ""),
        };
        using (html.In("p", ("id", "verdict"), ("class", look)))
        {
            html.Put("strong", mark + VerifyWords.Of(verdict));
            if (VerifyWords.Risk(verdict) is { } risk)
            {
                html.Text(" " + risk);
            }
        }

        if (report.Pair is { } pair)
        {
            html.Put("p", VerifyWords.Of(pair, report));
        }
    }
}
