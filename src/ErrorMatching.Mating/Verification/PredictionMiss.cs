namespace ErrorMatching.Mating;

/// <summary>How far the mating error of a counterpart, as it was measured, is from the one that was predicted before it was cut.</summary>
/// <param name="Point">Label of the key point.</param>
/// <param name="PredictedMm">The mating error that was predicted, along the normal.</param>
/// <param name="MeasuredMm">The mating error that was measured, along the normal.</param>
/// <param name="StandardUncertaintyMm">Standard uncertainty of the deviation that was decided about: the part's measurement is the same in
/// both errors, so it is the counterpart's alone, or that of both counterparts' in feedback.</param>
public readonly record struct PredictionMiss(string Point, double PredictedMm, double MeasuredMm, double StandardUncertaintyMm)
{
    /// <summary>Measured - predicted.</summary>
    public double Mm => MeasuredMm - PredictedMm;

    /// <summary>True if that is more than measuring explains: more than the expanded uncertainty with which deviations are decided about,
    /// k = 2.</summary>
    public bool IsSignificant => Math.Abs(Mm) > Decider.CoverageFactor * StandardUncertaintyMm;
}
