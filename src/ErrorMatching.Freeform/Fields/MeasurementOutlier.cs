namespace ErrorMatching.Freeform;

/// <summary>A measurement far from the others of the same point.</summary>
/// <param name="Point">Number of the point.</param>
/// <param name="Measurement">Index of the measurement in the given order, from 0.</param>
/// <param name="DifferenceMm">Its error minus the median error of the point, in millimeters.</param>
public sealed record MeasurementOutlier(int Point, int Measurement, double DifferenceMm);
