using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>By what a correction is made, and the offsets that the program to cut needs.</summary>
/// <param name="Kind">The kind; null if nothing is corrected.</param>
/// <param name="Radius">The correction of the tool's radius: 0 where the job allows one and none is needed; null if it is not
/// touched.</param>
/// <param name="Work">The correction of the work offset, in the same way.</param>
/// <param name="DifferenceMm">How far the boundary by the offset is from the one by blocks, or from where it should be, at most, mm; 0 for
/// blocks.</param>
/// <param name="Refused">Why smaller kinds do not suffice, in the order of the kinds.</param>
/// <param name="Program">The program that brings the control to these offsets; null if it needs none.</param>
public sealed record CorrectionChoice(
    CorrectionKind? Kind,
    RadiusCorrection? Radius,
    WorkOffsetCorrection? Work,
    double DifferenceMm,
    IReadOnlyList<KindRefused> Refused,
    byte[]? Program)
{
    /// <summary>The error that is expected of the offset; null for blocks, and in reports of earlier versions.</summary>
    public ExpectedError? Expected { get; init; }

    /// <summary>The error that would be expected of blocks; null in the same cases, and where blocks cannot follow.</summary>
    public ExpectedError? ExpectedByBlocks { get; init; }

    /// <summary>The program that takes this correction back: the offsets are then as before it, in feed-forward without a correction. Null
    /// if there is no <see cref="Program"/>.</summary>
    public byte[]? Undo { get; init; }

    /// <summary>True if the correction is made by an offset, and the program stays as it is.</summary>
    public bool IsOffset => Kind is CorrectionKind.ToolWear or CorrectionKind.WorkOffset;

    /// <summary>How far this correction moves the boundary toward the tool beyond the correction before, mm.</summary>
    public double StepRadiusMm => Kind == CorrectionKind.ToolWear ? (double)(Radius!.TotalMm - (Radius.BeforeMm ?? 0)) : 0;

    /// <summary>How far all corrections together move the boundary toward the tool, mm.</summary>
    public double TotalRadiusMm => (double)(Radius?.TotalMm ?? 0);

    /// <summary>How all corrections together move the program in its own frame.</summary>
    public RigidTransform2 TotalMove => Work?.Total is { } total
        ? OffsetFit.Move((double)total.XMm, (double)total.YMm, (double)total.RotationDegrees)
        : RigidTransform2.Identity;

    /// <summary>How this correction moves the program in its own frame beyond the correction before.</summary>
    public RigidTransform2 StepMove
    {
        get
        {
            if (Kind != CorrectionKind.WorkOffset)
            {
                return RigidTransform2.Identity;
            }

            var (total, before) = (Work!.Total, Work.Before ?? default);
            return OffsetFit.Move(
                (double)(total.XMm - before.XMm),
                (double)(total.YMm - before.YMm),
                (double)(total.RotationDegrees - before.RotationDegrees));
        }
    }
}

/// <summary>Why a kind of correction does not suffice.</summary>
/// <param name="Kind">The kind.</param>
/// <param name="Reason">The reason, as the end of a sentence.</param>
public sealed record KindRefused(CorrectionKind Kind, string Reason);
