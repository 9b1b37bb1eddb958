namespace ErrorMatching.Mating;

/// <summary>Difference between a counterpart's measured mating error and the one predicted before cutting.</summary>
/// <param name="Point">Label of the key point.</param>
/// <param name="PredictedMm">The predicted mating error along the normal.</param>
/// <param name="MeasuredMm">The measured mating error along the normal.</param>
/// <param name="StandardUncertaintyMm">Standard uncertainty of the deviation that the decision was based on. Both errors contain the same
/// measurement of the part, so it is the counterpart's alone, or that of both counterparts in feedback.</param>
public readonly record struct PredictionMiss(string Point, double PredictedMm, double MeasuredMm, double StandardUncertaintyMm)
{
    /// <summary>Measured - predicted.</summary>
    public double Mm => MeasuredMm - PredictedMm;

    /// <summary>True if the difference exceeds the expanded uncertainty used for decisions (k = 2), so that measuring does not explain
    /// it.</summary>
    public bool IsSignificant => Math.Abs(Mm) > UncertaintyBudget.CoverageFactor * StandardUncertaintyMm;
}
