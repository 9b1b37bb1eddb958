using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>One motion of the tool's center, mm, in work coordinates.</summary>
/// <param name="Motion">Position of the programmed motion that causes it; for a corner, of the motion after it.</param>
/// <param name="Kind">How the control moves.</param>
/// <param name="Plane">The plane of arcs and compensation.</param>
/// <param name="IsInserted">True if the control inserts it to go around a corner, or to a contour or away from it over a point that it
/// computes.</param>
/// <param name="IsCompensated">True if the tool's center is beside the programmed path at its end.</param>
/// <param name="Start">Its start.</param>
/// <param name="End">Its end.</param>
/// <param name="Center">Center of an arc, in the plane's coordinates.</param>
/// <param name="Turns">Full turns of an arc beyond the first.</param>
/// <param name="UnknownEnd">Axes whose end the program does not determine.</param>
public readonly record struct CompensatedMotion(
    int Motion,
    MotionKind Kind,
    CoordinatePlane Plane,
    bool IsInserted,
    bool IsCompensated,
    Point3 Start,
    Point3 End,
    Point2 Center,
    int Turns,
    AxisSet UnknownEnd)
{
    /// <summary>True for arcs and helices.</summary>
    public bool IsArc => Kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
}
