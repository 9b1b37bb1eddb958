using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Report texts of the verdict on a pair.</summary>
public static class VerdictWords
{
    /// <summary>The verdict in words: how many points will be within their limits, the worst error left, and whether to cut.</summary>
    public static string Of(MatchVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        var unchanged = (verdict.IsCompensated ? "" : " Nothing is compensated: the program stays as it is.")
            + (verdict.OffsetsToDo is { } offsets ? $" {offsets}" : "");
        return verdict.Code switch
        {
            VerdictCode.Within => $"{Within(verdict)}.{unchanged} Cut it.",
            VerdictCode.NoLimits => (verdict.Worst is { } worst
                ? $"No feature has limits with a width; the worst error left will be {Size(worst)}."
                : "There are no key points.") + $"{unchanged} Cut it.",
            VerdictCode.NotAccepted =>
                $"{Within(verdict)}, but the decision rule does not accept {Points(verdict.NotAccepted)}: too near the "
                    + $"{(verdict.NotAccepted.Count == 1 ? "limit" : "limits")}.{unchanged} Do not cut it unless you accept the risk.",
            VerdictCode.OutsideBetween =>
                $"{Within(verdict)}, but {ReportNames.Of(verdict.OutsideBetween)} will be outside between them.{unchanged} "
                    + "Do not cut it unless that is acceptable there.",
            VerdictCode.Outside =>
                $"{ReportNumber.Count(verdict.Outside.Count)} of {ReportNumber.Count(verdict.Points)} points will be outside "
                    + $"{Limits(verdict, verdict.Outside.Count)}: {Points(verdict.Outside)}{Furthest(verdict)}."
                    + (verdict.OutsideBetween.Count > 0 ? $" So will {ReportNames.Of(verdict.OutsideBetween)} between the points." : "")
                    + $"{unchanged} Do not cut it unless that is acceptable there.",
            _ => "The proof of the program does not hold. Do not use it.",
        };
    }

    /// <summary>The risk that a point will be outside its limits, with the program and without compensation; null if it is not
    /// known.</summary>
    public static string? Risk(MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return report.ProbabilityAfter is not { } after ? null
            : $"Risk that a point will be outside its limits: {ReportNumber.Probability(1 - after)}"
                + (!report.IsCorrected || report.ProbabilityBefore is not { } before ? ""
                    : $" (without compensation: {ReportNumber.Probability(1 - before)})")
                + ".";
    }

    /// <summary>The worst error at the key points and the worst place between them, with signs, intervals and names; null without key
    /// points.</summary>
    public static string? Worst(MatchVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return verdict.Worst is not { } worst ? null
            : $"Worst at the points: {Signed(worst)} mm at point {worst.Point} of {worst.Feature}"
                + (verdict.WorstBetween is { } between
                    ? $"; between them: {Signed(between)} mm on {between.Feature} near {Place(between)}"
                    : "")
                + ".";
    }

    /// <summary>A place in a sentence: <c>X-40.933 Y52.975</c>.</summary>
    internal static string Place(ErrorLeft error) => $"X{ReportNumber.Plain(error.Place.X)} Y{ReportNumber.Plain(error.Place.Y)}";

    /// <summary>An error with its sign and its interval, without unit.</summary>
    internal static string Signed(ErrorLeft error) => ReportNumber.Interval(error.MatingErrorMm, error.Interval95Mm);

    private static string Within(MatchVerdict verdict) =>
        $"{ReportNumber.Count(verdict.Within)} of {ReportNumber.Count(verdict.Points)} points will be within "
            + $"{Limits(verdict, verdict.Points)}{Parenthesis(verdict)}";

    private static string Parenthesis(MatchVerdict verdict) => verdict switch
    {
        { Limits: null, Tightest: { } tightest } =>
            $" (tightest {Size(tightest)} within {Band(tightest.Limits)}, at point {tightest.Point})",
        { Worst: { } worst } => $" (worst {Size(worst)})",
        _ => "",
    };

    private static string Furthest(MatchVerdict verdict) => verdict.Tightest is not { MarginMm: < 0 } t ? ""
        : verdict.Outside.Count == 1 ? $", by {Size(-t.MarginMm, t.Interval95Mm)}"
        : $", point {t.Point} the furthest, by {Size(-t.MarginMm, t.Interval95Mm)}";

    private static string Limits(MatchVerdict verdict, int points) =>
        verdict.Limits is { } limits ? Band(limits) : points == 1 ? "its limits" : "their limits";

    /// <summary>Limits in a sentence: <c>±0.05</c>, or from one to the other.</summary>
    internal static string Band(ToleranceBand band) => band.LowerMm == -band.UpperMm
        ? "±" + Limit(band.UpperMm)
        : $"{Sided(band.LowerMm)} to {Sided(band.UpperMm)}";

    private static string Sided(double mm) => (mm > 0 ? "+" : "") + Limit(mm);

    // A limit by a tolerance chain has digits without end.
    private static string Limit(double mm) => ReportNumber.Short(Math.Round(mm, 4));

    /// <summary>The size of an error with its interval, without unit.</summary>
    internal static string Size(ErrorLeft error) => Size(error.MatingErrorMm, error.Interval95Mm);

    /// <summary>The size of a length with its interval, without unit.</summary>
    internal static string Size(double mm, double? interval)
    {
        // Two digits of the interval: an error is not known better.
        var format = interval is < 0.00995 ? "0.0000" : "0.000";
        return Math.Abs(mm).ToString(format, CultureInfo.InvariantCulture)
            + (interval is { } half ? " ± " + half.ToString(format, CultureInfo.InvariantCulture) : "");
    }

    /// <summary>Points by their labels.</summary>
    internal static string Points(IReadOnlyList<string> labels) => (labels.Count == 1 ? "point " : "points ") + ReportNames.Of(labels);
}
