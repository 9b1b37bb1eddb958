using ErrorMatching.Measurement;

namespace ErrorMatching.Freeform;

/// <summary>The inputs of a compensation.</summary>
/// <param name="Job">The job.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Plan">The measuring plan used for the measurement.</param>
/// <param name="Measured">The measured piece: one file per measurement.</param>
public sealed record CompensationInput(FreeformJob Job, PartSurface Surface, MeasuringPlan Plan, IReadOnlyList<MeasuredPoints> Measured)
{
    /// <summary>The lot with the pieces before this one, and with what the program that cut it had corrected; null for the first
    /// piece.</summary>
    public MeasuredLot? Previous { get; init; }

    /// <summary>Earlier pieces that the same program cut, oldest first, each with its measurements. All of them compensate
    /// together.</summary>
    public IReadOnlyList<IReadOnlyList<MeasuredPoints>> Earlier { get; init; } = [];
}
