using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface laid through a grid of points.</summary>
/// <param name="Method">The way of fitting; where the best was asked for, <see cref="FitMethod.Best"/>.</param>
/// <param name="Surface">The surface.</param>
/// <param name="BreaksU">Parameters u at which a break of the curvature was found.</param>
/// <param name="BreaksV">Parameters v at which a break of the curvature was found.</param>
/// <param name="LeaveLineOutMm">Mean distance of the points of whole grid lines from the surface fitted without their line; NaN if there are too few lines.</param>
public sealed record FittedSurface(FitMethod Method, SplineSurface Surface, IReadOnlyList<double> BreaksU, IReadOnlyList<double> BreaksV, double LeaveLineOutMm);
