using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point of a plan with what was measured there.</summary>
/// <param name="Planned">The point of the plan.</param>
/// <param name="Contact">Where the ball touched the surface, in millimetres.</param>
/// <param name="Line">Line of the file that it was read from.</param>
public sealed record MeasuredPoint(PlanPoint Planned, Point3 Contact, int Line);
