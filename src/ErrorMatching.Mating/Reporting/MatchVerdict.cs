using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The verdict on the pair that a setter decides by: how many key points will be within their limits, the largest error that
/// will be left, and whether to cut.</summary>
/// <remarks>It follows from the report, also from one of an earlier version. A feature with limits without width asks for a correction,
/// not for conformance: its points are neither within nor outside.</remarks>
public sealed record MatchVerdict
{
    // The bound of a boundary whose points are near to each other is 1.1 to 2.8 times as wide as the interval of one point (samples): it
    // holds everywhere, on all features.
    private const double TooFarApart = 3;

    private MatchVerdict()
    {
    }

    /// <summary>The result in one word.</summary>
    public required VerdictCode Code { get; init; }

    /// <summary>True if the counterpart can be cut; false if somebody has to decide first.</summary>
    public bool IsToCut => Code is VerdictCode.Within or VerdictCode.NoLimits or VerdictCode.CheckOrigin or VerdictCode.NotKnownBetween;

    /// <summary>What the measured points say about each other; null in reports of earlier versions.</summary>
    public required MeasurementTrust? Trust { get; init; }

    /// <summary>True if something is corrected, by the program or by an offset.</summary>
    public required bool IsCompensated { get; init; }

    /// <summary>What to do with the control's offsets before cutting, in a sentence; null if nothing.</summary>
    public string? OffsetsToDo { get; init; }

    /// <summary>Number of key points with limits.</summary>
    public required int Points { get; init; }

    /// <summary>Number of those that will be within their limits.</summary>
    public int Within => Points - Outside.Count;

    /// <summary>Labels of the key points that will be outside their limits, in the order of cutting.</summary>
    public required IReadOnlyList<string> Outside { get; init; }

    /// <summary>Labels of the key points within their limits that the guard bands of the job's rule do not accept; none without such
    /// bands.</summary>
    public required IReadOnlyList<string> NotAccepted { get; init; }

    /// <summary>Names of the features that are expected to be outside their limits between the key points.</summary>
    public required IReadOnlyList<string> OutsideBetween { get; init; }

    /// <summary>Names of the features with limits of whose boundary between the key points nothing is known.</summary>
    public required IReadOnlyList<string> NotKnownBetween { get; init; }

    /// <summary>The bounds of the features with limits that are expected within them between the key points, but may be outside, because
    /// the points are too far apart to tell; the largest first.</summary>
    public required IReadOnlyList<ErrorLeft> DoubtfulBetween { get; init; }

    /// <summary>Names of the features within their limits between the key points whose bounds there the guard bands of the job's rule do
    /// not accept; none without such bands.</summary>
    public required IReadOnlyList<string> NotAcceptedBetween { get; init; }

    /// <summary>The limits of the mating error if all points have the same; otherwise null.</summary>
    public required ToleranceBand? Limits { get; init; }

    /// <summary>The limits of the mating error, of each feature.</summary>
    public required IReadOnlyList<ToleranceBand> AllLimits { get; init; }

    /// <summary>The part put into the counterpart; null if the outline does not tell, and in reports of earlier versions.</summary>
    public required PairAssembly? Pair { get; init; }

    /// <summary>The error with the largest magnitude that will be left at a key point; null without key points.</summary>
    public required ErrorLeft? Worst { get; init; }

    /// <summary>The error left at the key point with limits that is the nearest to its limits, or the furthest beyond them; null without
    /// limits.</summary>
    public required ErrorLeft? Tightest { get; init; }

    /// <summary>The error with the largest magnitude that is expected between the key points of a feature; if nothing is known of one, that
    /// one, at the place where one more point would tell most. Null if no feature has two points, and in reports of earlier
    /// versions.</summary>
    public required ErrorLeft? WorstBetween { get; init; }

    /// <summary>The probability that every key point will be within its limits, if the errors of the points are independent; null without
    /// limits, and in reports of earlier versions.</summary>
    public required double? ProbabilityAfter { get; init; }

    /// <summary>The verdict on a report.</summary>
    internal static MatchVerdict Judge(MatchReport report)
    {
        var limits = report.Features.ToDictionary(f => f.Name, f => f.Tolerance.Band.Opposite(), StringComparer.Ordinal);
        ReportKeyPoint[] judged = [.. report.KeyPoints.Where(p => LimitsOf(p).WidthMm > 0)];
        var rule = report.Rule ?? DecisionRule.Simple;
        IReadOnlyList<string> outside = [.. judged.Where(p => !LimitsOf(p).Contains(p.PredictedMm)).Select(p => p.Point)];
        IReadOnlyList<string> notAccepted = [
            .. judged.Where(p => LimitsOf(p).Contains(p.PredictedMm)
                && rule.AcceptanceLimits(LimitsOf(p), (p.Interval95Mm ?? 0) / PredictedError.Factor95)?.Contains(p.PredictedMm) != true)
            .Select(p => p.Point)];
        IReadOnlyList<string> between = [
            .. report.Features.Where(f => f.WorstBetween is { } e && limits[f.Name] is { WidthMm: > 0 } l && !l.Contains(e.AfterMm))
                .Select(f => f.Name)];
        IReadOnlyList<string> notKnown = [
            .. report.Features.Where(f => f.WorstBetween is { IsKnown: false } && limits[f.Name].WidthMm > 0).Select(f => f.Name)];
        ErrorLeft[] bounds = [
            .. report.Features.Select(ErrorLeft.Between).OfType<ErrorLeft>()
                .Where(e => e is { IsKnown: true, IsOutside: false, Interval95Mm: not null, Limits.WidthMm: > 0 })];
        IReadOnlyList<string> betweenNotAccepted = [
            .. bounds.Where(e => rule.IsGuarded
                && rule.AcceptanceLimits(e.Limits, e.Interval95Mm!.Value / PredictedError.Factor95)?.Contains(e.MatingErrorMm) != true)
                .Select(e => e.Feature)];

        // Half the interval of a key point is what the gauge leaves open. Where the bound is much wider, more points would help.
        ErrorLeft[] doubtful = [
            .. bounds.Where(e => e.MarginMm < e.Interval95Mm && e.Interval95Mm > TooFarApart * report.KeyPoints
                .Where(p => p.Feature == e.Feature).Select(p => p.Interval95Mm ?? double.PositiveInfinity)
                .DefaultIfEmpty(double.PositiveInfinity).Max())
                .OrderByDescending(e => e.BoundMm)];
        var all = judged.Select(p => LimitsOf(p)).Distinct().ToArray();
        return new()
        {
            Code = !report.Proof.Holds ? VerdictCode.ProofFails
                : report.Trust is { Suspects.Count: > 0 } ? VerdictCode.SuspectPoints
                : outside.Count > 0 ? VerdictCode.Outside
                : report.Pair?.IsWithin(limits.Values) == false ? VerdictCode.WillNotAssemble
                : between.Count > 0 ? VerdictCode.OutsideBetween
                : notAccepted.Count + betweenNotAccepted.Count > 0 ? VerdictCode.NotAccepted
                : report.Trust is { Motion.AsksForOrigin: true } ? VerdictCode.CheckOrigin
                : judged.Length == 0 ? VerdictCode.NoLimits
                : notKnown.Count + doubtful.Length > 0 ? VerdictCode.NotKnownBetween
                : VerdictCode.Within,
            Trust = report.Trust,
            IsCompensated = report.IsCorrected,
            OffsetsToDo = CorrectionWords.ToDo(report.Correction),
            Points = judged.Length,
            Outside = outside,
            NotAccepted = notAccepted,
            OutsideBetween = between,
            NotKnownBetween = notKnown,
            DoubtfulBetween = doubtful,
            NotAcceptedBetween = betweenNotAccepted,
            Limits = all.Length == 1 ? all[0] : null,
            AllLimits = [.. limits.Values],
            Pair = report.Pair,
            Worst = Largest(report.KeyPoints.Select(Left)),
            Tightest = judged.Select(Left).MinBy(e => e.MarginMm),
            WorstBetween = report.Features.Select(ErrorLeft.Between).OfType<ErrorLeft>()
                .OrderBy(e => e.IsKnown)
                .ThenByDescending(e => e.Limits.WidthMm > 0 && !e.Limits.Contains(e.MatingErrorMm) ? Math.Abs(e.MatingErrorMm) : 0)
                .ThenByDescending(e => e.BoundMm)
                .FirstOrDefault(),
            ProbabilityAfter = report.ProbabilityAfter,
        };

        ErrorLeft Left(ReportKeyPoint p) =>
            new(p.Feature, p.Point, p.Theoretical, p.Normal, p.PredictedMm, p.Interval95Mm, LimitsOf(p));

        ToleranceBand LimitsOf(ReportKeyPoint point) => limits.GetValueOrDefault(point.Feature) ?? ToleranceBand.Zero;
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("code", ReportWords.Of(Code));
        w.Flag("cut", IsToCut);
        w.Flag("compensated", IsCompensated);
        w.Count("points", Points);
        w.Count("pointsWithin", Within);
        w.Texts("outside", Outside);
        w.Texts("notAccepted", NotAccepted);
        w.Texts("outsideBetween", OutsideBetween);
        w.Texts("notKnownBetween", NotKnownBetween);
        w.Texts("doubtfulBetween", [.. DoubtfulBetween.Select(e => e.Feature)]);
        w.Texts("notAcceptedBetween", NotAcceptedBetween);
        w.Optional("worst", Worst, e => e.Write(w));
        w.Optional("worstBetween", WorstBetween, e => e.Write(w));
        w.Number("probabilityAfter", ProbabilityAfter);
        Trust?.Write(w);
        w.Text("sentence", VerdictWords.Of(this));
    }

    private static ErrorLeft? Largest(IEnumerable<ErrorLeft> errors) => errors.MaxBy(e => Math.Abs(e.MatingErrorMm));
}

/// <summary>A mating error that the program is predicted to leave: counterpart - part, positive where too much material stands.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Point">Label of the key point; null for a place between key points.</param>
/// <param name="Place">Where the boundary is as designed, in the part's frame.</param>
/// <param name="Normal">Unit normal there, from the counterpart's material to its tool, in the part's frame.</param>
/// <param name="MatingErrorMm">The error.</param>
/// <param name="Interval95Mm">Half its 95 % interval; null in reports of earlier versions.</param>
/// <param name="Limits">The limits of the mating error.</param>
public sealed record ErrorLeft(
    string Feature, string? Point, Point2 Place, Vector2 Normal, double MatingErrorMm, double? Interval95Mm, ToleranceBand Limits)
{
    /// <summary>False if nothing is known of the form of the boundary there.</summary>
    public bool IsKnown { get; init; } = true;

    /// <summary>The distance to the nearer limit; negative beyond it.</summary>
    public double MarginMm => Math.Min(MatingErrorMm - Limits.LowerMm, Limits.UpperMm - MatingErrorMm);

    /// <summary>The largest error, either way, that its interval holds.</summary>
    public double BoundMm => Math.Abs(MatingErrorMm) + (Interval95Mm ?? 0);

    /// <summary>True if it is outside its limits, which have a width.</summary>
    public bool IsOutside => Limits.WidthMm > 0 && !Limits.Contains(MatingErrorMm);

    /// <summary>The largest error expected between the key points of a feature; null if it has none.</summary>
    public static ErrorLeft? Between(ReportFeature feature)
    {
        ArgumentNullException.ThrowIfNull(feature);
        return feature.WorstBetween is { } e
            ? new(
                feature.Name, null, e.Place, e.Normal, e.AfterMm, e.IsKnown ? e.Interval95Mm : null, feature.Tolerance.Band.Opposite())
            {
                IsKnown = e.IsKnown,
            }
            : null;
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("feature", Feature);
        w.Text("point", Point);
        w.Point("place", Place);
        w.Flag("known", IsKnown);
        w.Number("predictedMm", MatingErrorMm);
        w.Number("interval95Mm", Interval95Mm);
    }
}

/// <summary>The verdict on a pair in one word.</summary>
public enum VerdictCode
{
    /// <summary>Every key point will be within its limits, and so will the boundary between them: cut.</summary>
    Within,

    /// <summary>No feature has limits with a width: cut, as far as limits tell.</summary>
    NoLimits,

    /// <summary>Every key point will be within its limits, but one motion of the whole part explains nearly all that was measured: cut, if
    /// the origin is right.</summary>
    CheckOrigin,

    /// <summary>Every key point will be within its limits, but those of a feature say nothing of the boundary between them, or too little:
    /// cut, if its form is good enough.</summary>
    NotKnownBetween,

    /// <summary>A key point will be within its limits, but inside the guard band of the job's rule.</summary>
    NotAccepted,

    /// <summary>The key points will be within their limits, but a place between them is expected to be outside.</summary>
    OutsideBetween,

    /// <summary>A key point will be outside its limits.</summary>
    Outside,

    /// <summary>The part and the counterpart overlap by more than the limits allow, however they are put together.</summary>
    WillNotAssemble,

    /// <summary>A measured point does not fit the others: measure it again.</summary>
    SuspectPoints,

    /// <summary>The proof of the program does not hold: do not use it.</summary>
    ProofFails,
}
