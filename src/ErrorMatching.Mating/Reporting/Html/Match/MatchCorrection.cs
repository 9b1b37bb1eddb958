using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section that says by what the correction is made, and why not by less.</summary>
internal static class MatchCorrection
{
    public static void Write(HtmlText html, ReportCorrection correction)
    {
        html.Put("p", CorrectionWords.ToDo(correction) ?? "No offset is touched.");
        foreach (var sentence in CorrectionWords.Why(correction))
        {
            html.Put("p", sentence);
        }
    }
}
