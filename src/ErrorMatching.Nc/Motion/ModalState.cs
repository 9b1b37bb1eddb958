using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The state that a control keeps from block to block.</summary>
internal struct ModalState
{
    public MotionKind Mode;

    /// <summary>The mode if it is a thread, a spline, an arc through a point or about the pole, or a tangential arc; otherwise
    /// unknown.</summary>
    public NcMeaning Form;

    public CoordinatePlane Plane;

    /// <summary>True if XY was stated and contours are still in it: another plane was stated since only with arcs.</summary>
    public bool WorksInXY;

    /// <summary>True if another plane than XY was stated, and no motion came since.</summary>
    public bool IsPlaneNew;

    public bool Inch;
    public bool InchFeed;
    public bool Incremental;
    public bool AbsoluteCenters;
    public MotionFlags Compensation;
    public bool CompensationSwitched;
    public NcMeaning Cycle;
    public bool RetractsToR;
    public bool InverseTime;
    public bool LengthOffset;
    public int Frame;
    public double Feed;
    public double ModalRounding;

    /// <summary>The pole for arcs and polar ends.</summary>
    public ArcPole Pole;

    /// <summary>The tool's place in programmed coordinates, and which of them are unknown.</summary>
    public Point3 Position;
    public AxisSet Unknown;

    public Unsure Unsure;

    /// <summary>The codes in force that what the control refuses depends on, and the letters given so far, as bits of its
    /// dialect's table.</summary>
    public ulong InForce;

    /// <summary>The modes that a motion stores.</summary>
    public readonly MotionFlags Flags =>
        (Inch ? MotionFlags.Inch : MotionFlags.None)
        | (Incremental ? MotionFlags.Incremental : MotionFlags.None)
        | (AbsoluteCenters ? MotionFlags.AbsoluteCenter : MotionFlags.None)
        | Compensation
        | (Unsure != Unsure.None ? MotionFlags.UnsureMode : MotionFlags.None);

    /// <summary>The plane of straight motions. A control has none for them unless it compensates, so that of the contours counts: after an
    /// arc in ZX that leads in, lines are in XY as before.</summary>
    public readonly CoordinatePlane StraightPlane =>
        WorksInXY && Compensation == MotionFlags.None && !CompensationSwitched ? CoordinatePlane.XY : Plane;

    /// <summary>True if an arc now leads out of the plane of the contours.</summary>
    public readonly bool IsArcVertical =>
        WorksInXY && Plane != CoordinatePlane.XY && Compensation == MotionFlags.None && !CompensationSwitched;

    /// <summary>A straight motion begins: a plane that was stated before it is that of the contours.</summary>
    public void TakePlane() => (WorksInXY, IsPlaneNew) = (WorksInXY && !IsPlaneNew, false);

    /// <summary>True if all of the state is equal, including the exact bits of the tool's place.</summary>
    public readonly bool SameAs(in ModalState other) =>
        Mode == other.Mode && Form == other.Form && Plane == other.Plane && WorksInXY == other.WorksInXY
        && IsPlaneNew == other.IsPlaneNew && Inch == other.Inch && InchFeed == other.InchFeed
        && Incremental == other.Incremental
            && AbsoluteCenters == other.AbsoluteCenters
            && Compensation == other.Compensation
            && CompensationSwitched == other.CompensationSwitched
        && Cycle == other.Cycle
            && RetractsToR == other.RetractsToR
            && InverseTime == other.InverseTime
            && LengthOffset == other.LengthOffset
            && Frame == other.Frame
        && Pole.SameAs(other.Pole)
        && Unknown == other.Unknown
            && Unsure == other.Unsure
            && InForce == other.InForce
            && Bits(Feed) == Bits(other.Feed)
            && Bits(ModalRounding) == Bits(other.ModalRounding)
        && Bits(Position.X) == Bits(other.Position.X)
            && Bits(Position.Y) == Bits(other.Position.Y)
            && Bits(Position.Z) == Bits(other.Position.Z);

    private static long Bits(double value) => BitConverter.DoubleToInt64Bits(value);

    /// <summary>The assumed state at the start of a program; each dialect states these assumptions.</summary>
    public static ModalState Initial => new() { Mode = MotionKind.Line, Unknown = AxisSet.All };
}

/// <summary>The place that a block of its own states for later arcs and polar ends (CC).</summary>
/// <param name="Place">The place in its plane, in programmed coordinates, mm.</param>
/// <param name="Plane">The plane of the two axes that it names.</param>
/// <param name="Frame">The layers of coordinates in which it was stated; it is known in these only.</param>
/// <param name="IsKnown">False if there is none, or if only the machine knows it.</param>
internal readonly record struct ArcPole(Point2 Place, CoordinatePlane Plane, int Frame, bool IsKnown)
{
    /// <summary>True if both are equal to the last bit.</summary>
    public bool SameAs(in ArcPole other) => Plane == other.Plane && Frame == other.Frame && IsKnown == other.IsKnown
        && BitConverter.DoubleToInt64Bits(Place.X) == BitConverter.DoubleToInt64Bits(other.Place.X)
        && BitConverter.DoubleToInt64Bits(Place.Y) == BitConverter.DoubleToInt64Bits(other.Place.Y);
}
