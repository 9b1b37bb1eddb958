using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>One motion of the programmed path, without cutter compensation, in mm, in the active work coordinates. A motion leads from
/// the previous end to the end that its block names.</summary>
/// <param name="Block">Position of its block in the program, from 0.</param>
/// <param name="Kind">How the control moves.</param>
/// <param name="Plane">The plane of an arc, and of compensation; of other motions, the plane in which contours are displaced.</param>
/// <param name="Flags">Modes and obstacles.</param>
/// <param name="Start">Its start.</param>
/// <param name="End">Its end.</param>
/// <param name="Center">Center of an arc, in the plane's coordinates.</param>
/// <param name="Turns">Full turns of an arc beyond the first; 0 for all but multi-turn helices.</param>
/// <param name="Feed">The last programmed feed, mm/min; 0 if there was none.</param>
/// <param name="Frame">Number of changes of work offset or origin before it: motions of different frames cannot be compared.</param>
/// <param name="UnknownStart">Axes whose start the program does not determine (its coordinate then reads as 0).</param>
/// <param name="UnknownEnd">Axes whose end the program does not determine.</param>
public readonly record struct NcMotion(
    int Block,
    MotionKind Kind,
    CoordinatePlane Plane,
    MotionFlags Flags,
    Point3 Start,
    Point3 End,
    Point2 Center,
    int Turns,
    double Feed,
    int Frame,
    AxisSet UnknownStart,
    AxisSet UnknownEnd)
{
    /// <summary>True for an arc in ZX or YZ between contours in XY, under no compensation: it leads into a contour or out of it.</summary>
    public bool IsVertical { get; init; }

    /// <summary>True for arcs and helices.</summary>
    public bool IsArc => Kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;

    /// <summary>True for straight and circular cuts.</summary>
    public bool IsCut => Kind is MotionKind.Line || IsArc;

    /// <summary>Start in the plane's coordinates.</summary>
    public Point2 PlaneStart => Plane.Project(Start);

    /// <summary>End in the plane's coordinates.</summary>
    public Point2 PlaneEnd => Plane.Project(End);

    /// <summary>The straight piece in the plane.</summary>
    public Segment2 Segment => new(PlaneStart, PlaneEnd);

    /// <summary>The arc in the plane, with its extra turns.</summary>
    public Arc2 Arc
    {
        get
        {
            var arc = Arc2.Between(PlaneStart, PlaneEnd, Center, Kind == MotionKind.ArcCounterClockwise);
            return Turns == 0 ? arc : arc with { Sweep = arc.Sweep + Angle.FromDegrees((arc.IsCounterClockwise ? 360 : -360) * Turns) };
        }
    }

    /// <summary>True if it moves in its plane, or may because it begins at an unknown place. A full circle does; a plunge or retract does
    /// not.</summary>
    public bool MovesInPlane => IsArc || PlaneStart != PlaneEnd || (UnknownStart & Plane.Axes()) != (UnknownEnd & Plane.Axes());

    /// <summary>True if the program determines its start and end in its plane.</summary>
    public bool IsKnownInPlane => ((UnknownStart | UnknownEnd) & Plane.Axes()) == AxisSet.None;

    /// <summary>Unit direction of travel in the plane at a fraction of the motion, 0 to 1.</summary>
    /// <exception cref="GeometryException">Its ends coincide in its plane.</exception>
    public Vector2 TangentAt(double fraction) => IsArc ? Arc.TangentAt(fraction) : (PlaneEnd - PlaneStart).Normalize();

    /// <summary>The point in the plane at a fraction of the motion, 0 to 1.</summary>
    public Point2 PlaneAt(double fraction) => IsArc ? Arc.At(fraction) : Segment.At(fraction);

    /// <summary>Length in the plane.</summary>
    public double PlaneLength => IsArc ? Arc.Length : Segment.Length;

    /// <summary>True for an arc to an angle about its center, which can be changed.</summary>
    internal bool IsToAngle => (Flags & (MotionFlags.PolarEnd | MotionFlags.Transformed)) == MotionFlags.PolarEnd;

    /// <summary>True if a transformation is active, and not only a polar end.</summary>
    internal bool IsTransformed => (Flags & (MotionFlags.PolarEnd | MotionFlags.Transformed)) == MotionFlags.Transformed;

    /// <summary>True for a helix to an angle about the center that a block before it states (CC, CP): none of its words says where it is,
    /// so it can only move as a whole.</summary>
    internal bool IsHelixToAngle => IsArc && Has(MotionFlags.CenterBefore) && Plane.Height(Start) != Plane.Height(End)
        && (Flags & (MotionFlags.PolarEnd | MotionFlags.Transformed)) == (MotionFlags.PolarEnd | MotionFlags.Transformed);

    /// <summary>True for an arc that leads to a contour and moves with it as a whole.</summary>
    internal bool IsLeadArc => IsVertical || IsHelixToAngle;

    /// <summary>True for a straight cut that ends where it begins.</summary>
    internal bool IsPoint => Kind == MotionKind.Line && Start == End;

    /// <summary>Axes in which a move to a machine position ends where it begins, because it does not name them.</summary>
    internal AxisSet CarriedAxes => (AxisSet)((int)Flags / (int)MotionFlags.CarriesX) & AxisSet.All;

    /// <summary>True if a flag is set.</summary>
    public bool Has(MotionFlags flag) => (Flags & flag) != MotionFlags.None;
}
