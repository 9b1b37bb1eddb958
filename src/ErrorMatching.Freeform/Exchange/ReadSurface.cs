using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface as read from its file, in millimeters.</summary>
/// <param name="Name">Its name in the file, or its number.</param>
/// <param name="Spline">The surface.</param>
/// <param name="Region">Its boundaries.</param>
internal sealed record ReadSurface(string Name, SplineSurface Spline, SurfaceRegion Region);
