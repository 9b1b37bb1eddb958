using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface as its file has it, in millimetres.</summary>
/// <param name="Name">What the file calls it, or its number there.</param>
/// <param name="Spline">The surface.</param>
/// <param name="Region">Its limits.</param>
internal sealed record ReadSurface(string Name, SplineSurface Spline, SurfaceRegion Region);
