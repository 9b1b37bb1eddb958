using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A boundary whose blocks are sought in a program.</summary>
/// <param name="Plane">The plane that it lies in.</param>
/// <param name="Points">Its key points in the order of cutting or against it, as they lie in the program, mm.</param>
public sealed record SoughtBoundary(CoordinatePlane Plane, IReadOnlyList<Point2> Points);
