using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A planned point with its measurement.</summary>
/// <param name="Planned">The planned point.</param>
/// <param name="Contact">Where the ball touched the surface, in millimeters.</param>
/// <param name="Line">Line of the file.</param>
public sealed record MeasuredPoint(PlanPoint Planned, Point3 Contact, int Line);
