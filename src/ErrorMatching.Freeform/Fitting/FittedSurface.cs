using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface fitted to a grid of points.</summary>
/// <param name="Method">The requested method, which may be <see cref="FitMethod.Best"/>.</param>
/// <param name="Surface">The surface.</param>
/// <param name="BreaksU">Parameters u at which a break of the curvature was found.</param>
/// <param name="BreaksV">Parameters v at which a break of the curvature was found.</param>
/// <param name="LeaveLineOutMm">Mean distance between points and the surface fitted without their grid line; NaN for too few lines.</param>
public sealed record FittedSurface(
    FitMethod Method, SplineSurface Surface, IReadOnlyList<double> BreaksU, IReadOnlyList<double> BreaksV, double LeaveLineOutMm)
{
    /// <summary>Of <see cref="FitMethod.Best"/>: mean distance of the points, in millimeters, from the best smooth surface, if that is far
    /// above the noise because it misses a part of their shape; otherwise 0.</summary>
    public double MissedMm { get; init; }

    /// <summary>True if the surface passes through every point for that reason.</summary>
    public bool IsThroughPoints { get; init; }
}
