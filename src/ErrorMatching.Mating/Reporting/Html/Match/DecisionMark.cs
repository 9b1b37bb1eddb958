using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A decision as a mark and words, so that it does not depend on color.</summary>
internal static class DecisionMark
{
    public static void Write(HtmlText html, Decision decision) =>
        html.Put("span", $"{Mark(decision)} {Words(decision)}", ("class", "mark " + ReportWords.Of(decision)));

    /// <summary>The decision in words.</summary>
    public static string Words(Decision decision) => decision switch
    {
        Decision.WithinTolerance => "within tolerance",
        Decision.NotSignificant => "not significant",
        _ => "compensated",
    };

    private static string Mark(Decision decision) =>
        decision switch { Decision.WithinTolerance => "✓", Decision.NotSignificant => "○", _ => "◆" };
}
