namespace ErrorMatching.Freeform;

/// <summary>Distances of points from a surface along its normals.</summary>
/// <param name="MeanMm">Mean absolute distance in millimeters.</param>
/// <param name="MaxMm">Largest absolute distance in millimeters.</param>
public readonly record struct DistanceSummary(double MeanMm, double MaxMm);
