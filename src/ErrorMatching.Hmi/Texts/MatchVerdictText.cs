using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The verdict on a pair in the display language: the numbers, and in English the words, of the report and the console.</summary>
internal static class MatchVerdictText
{
    /// <summary>How many points will be within their limits, the worst error left, and whether to cut.</summary>
    /// <param name="verdict">The verdict.</param>
    /// <param name="isToBeCut">False if cutting is no longer a question: then it is not answered.</param>
    public static string Of(MatchVerdict verdict, bool isToBeCut = true)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        var texts = Texts.Current;
        if (verdict.Code == VerdictCode.ProofFails)
        {
            return texts["Pair.ProofFails"];
        }

        var (result, act) = verdict.Code switch
        {
            VerdictCode.Within => (Within(verdict, "Pair.AllWithin"), "Pair.Cut"),
            VerdictCode.NoLimits => (
                verdict.Worst is { } worst ? texts.With("Pair.NoLimits", Size(worst)) : texts["Pair.NoPoints"], "Pair.Cut"),
            VerdictCode.CheckOrigin => (
                Sentence.Joined(Within(verdict, "Pair.AllWithin"), Origin(verdict.Trust!.Motion!)), "Pair.CutIfSo"),
            VerdictCode.NotKnownBetween => (
                Sentence.Joined(Within(verdict, "Pair.AllWithin"), NotKnown(verdict)), "Pair.CutIfGood"),
            VerdictCode.WillNotAssemble => (texts.With("Pair.Overlaps", Within(verdict)), "Pair.DoNotCut"),
            VerdictCode.SuspectPoints => (Suspects(verdict.Trust!.Suspects), "Pair.NotBefore"),
            VerdictCode.NotAccepted => (
                verdict.NotAcceptedBetween.Count == 0
                    ? texts.Counted(
                        "Pair.NotAccepted", verdict.NotAccepted.Count, Within(verdict), VerdictParts.Names(verdict.NotAccepted))
                    : NotAcceptedBetween(verdict),
                "Pair.AcceptRisk"),
            VerdictCode.OutsideBetween => (
                texts.With("Pair.OutsideBetween", Within(verdict), VerdictParts.Names(verdict.OutsideBetween)), "Pair.AcceptThere"),
            _ => (Outside(verdict), "Pair.AcceptThere"),
        };
        return Sentence.Joined(result, verdict.IsCompensated ? "" : texts["Pair.Unchanged"], isToBeCut ? texts[act] : "");
    }

    /// <summary>The worst error at the key points and between them, with signs, intervals and places; null without key points.</summary>
    public static string? Worst(MatchVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return (verdict.Worst, verdict.WorstBetween) switch
        {
            (null, _) => null,
            ({ } worst, null) => Texts.Current.With("Pair.Worst", Signed(worst), worst.Point!, worst.Feature),
            ({ } worst, { IsKnown: false } between) => Texts.Current.With(
                "Pair.WorstAndNotKnown", Signed(worst), worst.Point!, worst.Feature, between.Feature,
                $"X{ReportNumber.Plain(between.Place.X)} Y{ReportNumber.Plain(between.Place.Y)}"),
            ({ } worst, { } between) => Texts.Current.With(
                verdict.DoubtfulBetween.Contains(between) ? "Pair.WorstAndDoubtful" : "Pair.WorstAndBetween",
                Signed(worst), worst.Point!, worst.Feature, Signed(between), between.Feature,
                $"X{ReportNumber.Plain(between.Place.X)} Y{ReportNumber.Plain(between.Place.Y)}"),
        };
    }

    /// <summary>The error of which the most must be feared, at a key point or between them: first one of which nothing is known, then the
    /// one whose interval reaches farthest from zero; null without key points.</summary>
    public static ErrorLeft? Farthest(MatchVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return (verdict.Worst, verdict.WorstBetween) switch
        {
            ({ } worst, { IsKnown: true } between) => worst.BoundMm > between.BoundMm ? worst : between,
            var (worst, between) => between ?? worst,
        };
    }

    /// <summary>An error at its place in a picture: the point, or the feature between its points, and the error with its
    /// interval.</summary>
    public static string At(ErrorLeft error)
    {
        ArgumentNullException.ThrowIfNull(error);
        return Texts.Current.With(error.IsKnown ? "Pair.WorstAt" : "Pair.NotKnownAt", error.Point ?? error.Feature, Signed(error));
    }

    /// <summary>The risk that a point will be outside its limits, with the program and without compensation; null if it is not
    /// known.</summary>
    public static string? Risk(MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return report.ProbabilityAfter is not { } after ? null
            : report is { IsCorrected: true, ProbabilityBefore: { } before }
            ? Texts.Current.With("Pair.RiskBefore", VerdictParts.Percent(1 - after), VerdictParts.Percent(1 - before))
            : Texts.Current.With("Pair.Risk", VerdictParts.Percent(1 - after));
    }

    /// <summary>Severity of a verdict. Without limits nobody but the user can judge.</summary>
    public static Severity SeverityOf(VerdictCode code) => code switch
    {
        VerdictCode.Within => Severity.Quiet,
        VerdictCode.Outside or VerdictCode.WillNotAssemble or VerdictCode.SuspectPoints or VerdictCode.ProofFails => Severity.Alarm,
        _ => Severity.Attention,
    };

    // The first of them with its size; what to do is the same for all.
    private static string Suspects(IReadOnlyList<SuspectPoint> suspects) => Texts.Current.Counted(
        "Pair.Suspects", suspects.Count, suspects[0].Point, suspects[0].Feature, Shown.SignedMm(suspects[0].StandsOutMm),
        VerdictParts.Names([.. suspects.Select(s => s.Point)]));

    private static string NotKnown(MatchVerdict verdict)
    {
        var (unknown, doubtful) = (verdict.NotKnownBetween, verdict.DoubtfulBetween);
        return doubtful.Count == 0 ? Texts.Current.With("Pair.NotKnownBetween", VerdictParts.Names(unknown))
            : unknown.Count == 0 ? Texts.Current.With("Pair.DoubtfulBetween", Doubtful(), Bound())
            : Texts.Current.With("Pair.NotKnownAndDoubtful", VerdictParts.Names(unknown), Doubtful(), Bound());

        string Doubtful() => VerdictParts.Names([.. doubtful.Select(e => e.Feature)]);
        string Bound() => Shown.MmAsKnown(VerdictWords.Bound(doubtful[0]), null);
    }

    private static string NotAcceptedBetween(MatchVerdict verdict)
    {
        var (points, between) = (verdict.NotAccepted, VerdictParts.Names(verdict.NotAcceptedBetween));
        return points.Count == 0 ? Texts.Current.With("Pair.NotAcceptedBetween", Within(verdict), between)
            : Texts.Current.Counted(
                "Pair.NotAcceptedAndBetween", points.Count, Within(verdict), VerdictParts.Names(points), between);
    }

    private static string Origin(CommonMotion motion) => Texts.Current.With(
        "Pair.CheckOrigin", Shown.SignedMm(motion.ShiftMm.X), Shown.SignedMm(motion.ShiftMm.Y),
        Shown.Number(motion.TurnDeg), Shown.Percent(100 * motion.Explains));

    private static string Within(MatchVerdict verdict, string key = "Pair.Within") => Texts.Current.With(
        key,
        Shown.Count(verdict.Within),
        Shown.Count(verdict.Points),
        Limits(verdict, verdict.Points),
        verdict switch
        {
            { Limits: null, Tightest: { } tightest } =>
                Texts.Current.With("Pair.Tightest", Size(tightest), Band(tightest.Limits), tightest.Point!),
            { Worst: { } worst } => Texts.Current.With("Pair.WorstSize", Size(worst)),
            _ => "",
        });

    private static string Outside(MatchVerdict verdict)
    {
        var texts = Texts.Current;
        var furthest = verdict.Tightest is not { MarginMm: < 0 } t ? ""
            : verdict.Outside.Count == 1 ? texts.With("Pair.By", Shown.MmAsKnown(t.MarginMm, t.Interval95Mm))
            : texts.With("Pair.FurthestBy", t.Point!, Shown.MmAsKnown(t.MarginMm, t.Interval95Mm));
        return Sentence.Joined(
            texts.Counted(
                "Pair.Outside", verdict.Outside.Count, Shown.Count(verdict.Outside.Count), Shown.Count(verdict.Points),
                Limits(verdict, verdict.Outside.Count), VerdictParts.Names(verdict.Outside), furthest),
            verdict.OutsideBetween.Count > 0 ? texts.With("Pair.SoBetween", VerdictParts.Names(verdict.OutsideBetween)) : "");
    }

    private static string Limits(MatchVerdict verdict, int points) => verdict.Limits is { } limits
        ? Texts.Current.With("Pair.Limits", Band(limits))
        : Texts.Current[points == 1 ? "Pair.OwnLimitsOne" : "Pair.OwnLimits"];

    /// <summary>Limits in a sentence.</summary>
    internal static string Band(ToleranceBand band) => band.LowerMm == -band.UpperMm
        ? "±" + Short(band.UpperMm)
        : Texts.Current.With("Pair.Band", Sided(band.LowerMm), Sided(band.UpperMm));

    private static string Sided(double mm) => (mm > 0 ? "+" : "") + Short(mm);

    // All digits of a limit, with the minus sign of the station.
    private static string Short(double mm) => ReportNumber.Short(mm).Replace('-', '−');

    /// <summary>The size of an error with its interval.</summary>
    internal static string Size(ErrorLeft error) => Shown.MmAsKnown(error.MatingErrorMm, error.Interval95Mm);

    private static string Signed(ErrorLeft error) => Shown.SignedMm(error.MatingErrorMm, error.Interval95Mm);
}
