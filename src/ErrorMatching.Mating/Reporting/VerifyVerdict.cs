using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The verdict on a counterpart that is cut and measured: how many key points are within their limits, and the risk that one truly
/// is not.</summary>
/// <remarks>It follows from the report, also from one of an earlier version, which does not state the risk. The limits are those of the
/// mating error, opposite to those of the part's deviation.</remarks>
public sealed record VerifyVerdict
{
    private VerifyVerdict()
    {
    }

    /// <summary>The result in one word.</summary>
    public required VerifyCode Code { get; init; }

    /// <summary>True if the piece is in tolerance: no point is outside its limits, and the job's rule accepts all of them; null without
    /// limits.</summary>
    public bool? IsInTolerance => Code == VerifyCode.NoLimits ? null : Code == VerifyCode.Within && NotAccepted.Count == 0;

    /// <summary>Number of key points with limits.</summary>
    public required int Points { get; init; }

    /// <summary>Number of those within their limits.</summary>
    public int Within => Points - Outside.Count;

    /// <summary>Labels of the key points outside their limits, in the order of cutting.</summary>
    public required IReadOnlyList<string> Outside { get; init; }

    /// <summary>Labels of the key points within their limits that the guard bands of the job's rule do not accept.</summary>
    public required IReadOnlyList<string> NotAccepted { get; init; }

    /// <summary>The limits of the mating error if all points have the same; otherwise null.</summary>
    public required ToleranceBand? Limits { get; init; }

    /// <summary>The measured error with the largest magnitude.</summary>
    public required ErrorLeft Worst { get; init; }

    /// <summary>The measured error that is the nearest to its limits, or the furthest beyond them; null without limits.</summary>
    public required ErrorLeft? Tightest { get; init; }

    /// <summary>The probability that every key point truly is within its limits, if the errors of the points are independent; null without
    /// limits, and in reports of earlier versions.</summary>
    public required double? Probability { get; init; }

    /// <summary>The verdict on a report.</summary>
    internal static VerifyVerdict Judge(VerifyReport report)
    {
        var (result, u, rule) = (report.Result, report.UncertaintyMm, report.Rule ?? DecisionRule.Simple);
        ErrorLeft[] all = [.. result.Points.Select(Left)];
        ErrorLeft[] judged = [.. all.Where(e => e.Limits.WidthMm > 0)];
        ErrorLeft[] outside = [.. judged.Where(e => e.IsOutside)];
        var limits = judged.Select(e => e.Limits).Distinct().ToArray();
        return new()
        {
            Code = outside.Length > 0 ? VerifyCode.Outside : judged.Length > 0 ? VerifyCode.Within : VerifyCode.NoLimits,
            Points = judged.Length,
            Outside = [.. outside.Select(e => e.Point!)],
            NotAccepted = [
                .. judged.Where(e => !e.IsOutside && rule.AcceptanceLimits(e.Limits, u ?? 0)?.Contains(e.MatingErrorMm) != true)
                    .Select(e => e.Point!)],
            Limits = limits.Length == 1 ? limits[0] : null,
            Worst = all.MaxBy(e => Math.Abs(e.MatingErrorMm))!,
            Tightest = judged.MinBy(e => e.MarginMm),
            Probability = u is { } known
                ? Conformance.OfIndependent(judged.Select(e => Conformance.Probability(e.Limits, e.MatingErrorMm, known)))
                : null,
        };

        ErrorLeft Left(VerifiedPoint p) => new(
            result.BoundaryOf(p.Label)?.Name ?? "",
            p.Label,
            p.Part,
            p.Normal,
            p.AfterError.NormalMm,
            u * PredictedError.Factor95,
            result.BandOf(p.Label) ?? ToleranceBand.Zero);
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("code", VerifyWords.Of(Code));
        w.Flag("inTolerance", IsInTolerance);
        w.Count("points", Points);
        w.Count("pointsWithin", Within);
        w.Texts("outside", Outside);
        w.Texts("notAccepted", NotAccepted);
        w.Number("probability", Probability);
        w.Text("sentence", VerifyWords.Of(this));
    }
}

/// <summary>The verdict on a measured counterpart in one word.</summary>
public enum VerifyCode
{
    /// <summary>Every key point is within its limits.</summary>
    Within,

    /// <summary>No feature has limits with a width.</summary>
    NoLimits,

    /// <summary>A key point is outside its limits.</summary>
    Outside,
}
