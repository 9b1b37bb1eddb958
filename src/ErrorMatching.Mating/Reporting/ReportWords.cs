using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The words for enumeration values in reports: those of the job, if it has them.</summary>
public static class ReportWords
{
    /// <summary>compensated, within-tolerance or not-significant.</summary>
    public static string Of(Decision decision) => decision switch
    {
        Decision.WithinTolerance => "within-tolerance",
        Decision.NotSignificant => "not-significant",
        _ => "compensated",
    };

    /// <summary>within-limits, no-limits, check-origin, not-accepted, outside-between, outside-limits, suspect-points,
    /// will-not-assemble or proof-fails.</summary>
    public static string Of(VerdictCode code) => code switch
    {
        VerdictCode.Within => "within-limits",
        VerdictCode.NoLimits => "no-limits",
        VerdictCode.CheckOrigin => "check-origin",
        VerdictCode.NotKnownBetween => "not-known-between",
        VerdictCode.SuspectPoints => "suspect-points",
        VerdictCode.WillNotAssemble => "will-not-assemble",
        VerdictCode.NotAccepted => "not-accepted",
        VerdictCode.OutsideBetween => "outside-between",
        VerdictCode.Outside => "outside-limits",
        _ => "proof-fails",
    };

    /// <summary>simple or guard-band.</summary>
    public static string Of(DecisionRule rule)
    {
        ArgumentNullException.ThrowIfNull(rule);
        return rule.IsGuarded ? "guard-band" : "simple";
    }

    /// <summary>tool-wear, work-offset or blocks.</summary>
    public static string Of(CorrectionKind kind) => kind switch
    {
        CorrectionKind.ToolWear => "tool-wear",
        CorrectionKind.WorkOffset => "work-offset",
        _ => "blocks",
    };

    /// <summary>none, datum or best-fit.</summary>
    public static string Of(JobAlignmentKind kind) =>
        kind switch { JobAlignmentKind.None => "none", JobAlignmentKind.Datum => "datum", _ => "best-fit" };

    /// <summary>job, chain:worst-case or chain:rss.</summary>
    public static string Of(ToleranceSource source) =>
        source switch { ToleranceSource.Stated => "job", ToleranceSource.WorstCase => "chain:worst-case", _ => "chain:rss" };

    /// <summary>part or counterpart.</summary>
    public static string Of(CompensationSource source) => source == CompensationSource.Part ? "part" : "counterpart";

    /// <summary>whole or excess.</summary>
    public static string Of(CompensationAmount amount) => amount == CompensationAmount.Whole ? "whole" : "excess";

    /// <summary>normal or vector.</summary>
    public static string Of(CompensationDirection direction) => direction == CompensationDirection.Normal ? "normal" : "vector";

    /// <summary>slides, follows, fillet or positioning.</summary>
    public static string Of(NeighborRole role) => role switch
    {
        NeighborRole.Slides => "slides",
        NeighborRole.Fillet => "fillet",
        NeighborRole.Positioning => "positioning",
        _ => "follows",
    };

    /// <summary>A neighbor's role as a phrase after its block and before the distance: <c>slid along itself</c>.</summary>
    public static string Sentence(NeighborRole role) => role switch
    {
        NeighborRole.Slides => "slid along itself",
        NeighborRole.Fillet => "stayed tangent to both sides and moved",
        NeighborRole.Positioning => "positions to the new place, moved",
        _ => "followed",
    };

    /// <summary>none, x or y.</summary>
    public static string Of(Mirror mirror) => mirror switch { Mirror.X => "x", Mirror.Y => "y", _ => "none" };
}
