namespace ErrorMatching.Freeform;

/// <summary>A measurement that is far from the others of the same point.</summary>
/// <param name="Point">Number of the point.</param>
/// <param name="Measurement">Number of the measurement, from 0 in the order given.</param>
/// <param name="DifferenceMm">Its error less the median of the point's errors, in millimetres.</param>
public sealed record MeasurementOutlier(int Point, int Measurement, double DifferenceMm);
