using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>One motion as the peer prints it, in mm, in the work coordinates that are active.</summary>
/// <param name="Line">The N word of its block; null where the block has none.</param>
/// <param name="Kind">How it moves.</param>
/// <param name="Plane">The plane that is selected.</param>
/// <param name="End">Where it ends.</param>
/// <param name="Center">Center of an arc in its plane.</param>
/// <param name="Turns">Full turns beyond the first.</param>
/// <param name="Feed">Feed, mm/min; null where it is not one per minute.</param>
/// <param name="ResolutionMm">The unit of the last digit that is printed.</param>
/// <param name="IsSpline">True for a spline, whose end is not printed.</param>
internal sealed record PeerMotion(
    int? Line,
    MotionKind Kind,
    CoordinatePlane Plane,
    Point3 End,
    Point2 Center,
    int Turns,
    double? Feed,
    double ResolutionMm,
    bool IsSpline = false);
