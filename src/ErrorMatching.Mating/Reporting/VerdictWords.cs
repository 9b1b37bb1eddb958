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
            VerdictCode.CheckOrigin =>
                $"{Within(verdict)}.{unchanged} But {Motion(verdict.Trust!.Motion!)} of what was measured: is the origin right? "
                    + "Cut it if so.",
            VerdictCode.NotKnownBetween =>
                $"{Within(verdict)}.{unchanged} Between them, {Between(verdict)}. Cut it if the form there is good enough.",
            VerdictCode.WillNotAssemble =>
                $"{Within(verdict)}, but the pair overlaps by more than the limits allow.{unchanged} Do not cut it.",
            VerdictCode.SuspectPoints => $"{Suspects(verdict.Trust!.Suspects)} Do not cut it before.",
            VerdictCode.NotAccepted =>
                $"{Within(verdict)}, but the decision rule does not accept {NotAccepted(verdict)}: too near the "
                    + (verdict is { NotAccepted.Count: 1, NotAcceptedBetween.Count: 0 } ? "limit" : "limits")
                    + $".{unchanged} Do not cut it unless you accept the risk.",
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

    /// <summary>Points that do not fit the others: which, how far they stand out, and what to do.</summary>
    public static string Suspects(IReadOnlyList<SuspectPoint> suspects)
    {
        ArgumentNullException.ThrowIfNull(suspects);
        var first = suspects[0];
        var others = suspects.Count == 1 ? ""
            : $" Nor {(suspects.Count == 2 ? "does" : "do")} {Points([.. suspects.Skip(1).Select(s => s.Point)])}.";
        return $"Point {first.Point} of {first.Feature} does not fit the others: it stands out by "
            + $"{ReportNumber.SignedMm(first.StandsOutMm)}.{others} Measure {Points([.. suspects.Select(s => s.Point)])} again, or take "
            + $"{(suspects.Count == 1 ? "it" : "them")} out of the job (\"without\").";
    }

    /// <summary>One motion of the whole part, as the subject of a sentence, and the share that it explains.</summary>
    public static string Motion(CommonMotion motion)
    {
        ArgumentNullException.ThrowIfNull(motion);
        var turn = Math.Abs(motion.TurnDeg) <= 2 * motion.Uncertainty.TurnDeg ? ""
            : $" and a turn of {Turn(motion.TurnDeg)} ± {Turn(2 * motion.Uncertainty.TurnDeg).TrimStart('+')} degrees";
        return $"one shift of x {Shift(motion.ShiftMm.X, motion.Uncertainty.X)}, y {Shift(motion.ShiftMm.Y, motion.Uncertainty.Y)}{turn} "
            + $"{(turn.Length == 0 ? "explains" : "explain")} {ReportNumber.WholePercent(100 * motion.Explains)} %";

        static string Shift(double mm, double uncertainty) => $"{ReportNumber.Signed(mm)} ± {ReportNumber.Plain(2 * uncertainty)}";
        static string Turn(double degrees) => degrees.ToString("+0.0000;-0.0000;0.0000", CultureInfo.InvariantCulture);
    }

    /// <summary>What the points say about each other beside the verdict, in sentences.</summary>
    public static IEnumerable<string> Trust(MatchVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        if (verdict.Trust is not { } trust)
        {
            yield break;
        }

        if (trust.Suspects.Count > 0 && verdict.Code != VerdictCode.SuspectPoints)
        {
            yield return Suspects(trust.Suspects);
        }

        if (trust.Motion is { AsksForOrigin: true } motion && verdict.Code != VerdictCode.CheckOrigin)
        {
            yield return $"O{Motion(motion)[1..]} of what was measured: is the origin right?";
        }

        if (trust.Unchecked.Count > 0)
        {
            yield return $"The points of {ReportNames.Of(trust.Unchecked)} are too few to contradict each other: a wrong reading there "
                + "would not be noticed.";
        }
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
                + (verdict.WorstBetween is { IsKnown: false } notKnown
                    ? $"; between them not known: one more point near {Place(notKnown)} on {notKnown.Feature} would tell most, or "
                        + "\"formMm\" states the form error"
                    : verdict.WorstBetween is { } between
                    ? $"; between them: {Signed(between)} mm on {between.Feature} near {Place(between)}"
                        + (verdict.DoubtfulBetween.Contains(between) ? ", where one more point would tell most" : "")
                    : "")
                + ".";
    }

    /// <summary>A place in a sentence: <c>X-40.933 Y52.975</c>.</summary>
    internal static string Place(ErrorLeft error) => $"X{ReportNumber.Plain(error.Place.X)} Y{ReportNumber.Plain(error.Place.Y)}";

    /// <summary>An error with its sign and its interval, without unit.</summary>
    internal static string Signed(ErrorLeft error) => ReportNumber.Interval(error.MatingErrorMm, error.Interval95Mm);

    // What is not known, and what is not known well enough.
    private static string Between(MatchVerdict verdict)
    {
        var (unknown, doubtful) = (verdict.NotKnownBetween, verdict.DoubtfulBetween);
        var bound = doubtful.Count == 0 ? ""
            : $"{ReportNames.Of([.. doubtful.Select(e => e.Feature)])} may be off by up to {Size(Bound(doubtful[0]), null)}";
        return unknown.Count == 0 ? bound
            : $"nothing is known of {ReportNames.Of(unknown)}" + (bound.Length == 0 ? "" : $", and {bound}");
    }

    /// <summary>The largest error that an interval holds, mm, rounded up: it must not look as if it were within its limits.</summary>
    public static double Bound(ErrorLeft error)
    {
        ArgumentNullException.ThrowIfNull(error);
        return Math.Ceiling((error.BoundMm * 1000) - 1e-6) / 1000;
    }

    private static string NotAccepted(MatchVerdict verdict)
    {
        var (points, between) = (verdict.NotAccepted, verdict.NotAcceptedBetween);
        return (points.Count == 0 ? "" : Points(points))
            + (points.Count > 0 && between.Count > 0 ? ", nor " : "")
            + (between.Count == 0 ? "" : $"{ReportNames.Of(between)} between the points");
    }

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
