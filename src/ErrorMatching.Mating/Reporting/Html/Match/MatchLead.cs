using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What a setter reads first: the verdict on the pair, the risk, and the worst error left.</summary>
internal static class MatchLead
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var verdict = report.Verdict;
        using (html.In("p", ("id", "verdict"), ("class", verdict.IsToCut ? "verdict holds" : "verdict fails")))
        {
            html.Put("strong", $"{(verdict.IsToCut ? "✓" : "✗")} {VerdictWords.Of(verdict)}");
            string?[] more = [report.Acceptance.Sentence, VerdictWords.Risk(report), VerdictWords.Worst(verdict)];
            html.Text(string.Join(" ", more.OfType<string>().Concat(VerdictWords.Trust(verdict))));
            if (report.Warnings.Count > 0)
            {
                html.Text(" ");
                html.Put(
                    "a",
                    report.Warnings.Count == 1 ? "Read the warning first." : $"Read the {report.Warnings.Count} warnings first.",
                    ("href", "#summary"));
            }
        }

        if (report.Pair is { } pair)
        {
            html.Put("p", PairWords.Of(pair, verdict.AllLimits), ("id", "pair-verdict"));
        }
    }
}
