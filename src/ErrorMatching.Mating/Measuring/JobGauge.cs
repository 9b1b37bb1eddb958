using ErrorMatching.Measurement;

namespace ErrorMatching.Mating;

/// <summary>The gauge's file format and accuracy.</summary>
/// <param name="Format">The format of its files.</param>
/// <param name="Uncertainty">Standard uncertainty of a measured coordinate.</param>
/// <param name="Reports">The meaning of the coordinates in its files.</param>
/// <param name="StylusDiameterMm">Diameter of the stylus ball; null if the job does not need and does not state it.</param>
/// <param name="Measuring">The terms of equation (7).</param>
public sealed record JobGauge(
    MeasurementFormat Format, UncertaintyBudget Uncertainty, ProbeReport Reports, double? StylusDiameterMm, MeasuringTime Measuring)
{
    /// <summary>True if the job accepts the gauge although its expanded uncertainty exceeds the width of a feature's limits.</summary>
    public bool AcceptsCoarse { get; init; }

    /// <summary>The rule by which the gauge names the key points; null if it uses the labels of the job.</summary>
    public LabelRule? Labels { get; init; }

    /// <summary>The key points in the order in which logs without labels have them; empty for the order of the theoretical file.</summary>
    public IReadOnlyList<string> Order { get; init; } = [];
}

/// <summary>The meaning of the coordinates in a gauge's file.</summary>
public enum ProbeReport
{
    /// <summary>Points where the stylus touched the piece.</summary>
    Contact,

    /// <summary>Centers of the stylus ball at the moment of touch.</summary>
    StylusCenter,
}
