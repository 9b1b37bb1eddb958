using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>What a control remembers from block to block.</summary>
internal struct ModalState
{
    public MotionKind Mode;
    public CoordinatePlane Plane;
    public bool Inch;
    public bool Incremental;
    public bool AbsoluteCenters;
    public MotionFlags Compensation;
    public bool CompensationSwitched;
    public bool CycleActive;
    public ulong Transforms;
    public int WorkOffset;
    public int Frame;
    public double Feed;
    public Point3 Position;
    public AxisSet Unknown;
    public Unsure Unsure;

    /// <summary>The state a program starts in, as far as it does not say otherwise; each dialect states these assumptions.</summary>
    public static ModalState Initial => new() { Mode = MotionKind.Line, WorkOffset = 540, Unknown = AxisSet.All };
}
