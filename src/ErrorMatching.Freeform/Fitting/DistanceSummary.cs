namespace ErrorMatching.Freeform;

/// <summary>How far points lie from a surface along its normals.</summary>
/// <param name="MeanMm">Mean of the distances regardless of their side, in millimetres.</param>
/// <param name="MaxMm">The largest of them.</param>
public readonly record struct DistanceSummary(double MeanMm, double MaxMm);
