using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The residual of an alignment at a point.</summary>
/// <param name="Point">Label of the point.</param>
/// <param name="Left">Aligned - theoretical.</param>
public sealed record ReportResidual(string Point, Vector2 Left);
