using ErrorMatching.Measurement;

namespace ErrorMatching.Mating;

/// <summary>What the gauge writes and how well it measures.</summary>
/// <param name="Format">How its files look.</param>
/// <param name="Uncertainty">Standard uncertainty of a measured coordinate.</param>
/// <param name="Reports">What the coordinates in its files are.</param>
/// <param name="StylusDiameterMm">Diameter of the stylus ball; null where the job does not say and does not need it.</param>
/// <param name="Measuring">The terms of equation (7).</param>
public sealed record JobGauge(
    MeasurementFormat Format, UncertaintyBudget Uncertainty, ProbeReport Reports, double? StylusDiameterMm, MeasuringTime Measuring);
