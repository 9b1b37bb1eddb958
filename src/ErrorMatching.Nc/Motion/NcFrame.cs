using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The layers between programmed coordinates and the machine, from one block on. A motion names its frame by number.</summary>
/// <param name="Block">Position of the first block in which it is active; 0 for the first frame.</param>
/// <param name="WorkOffset">The work offset as its code times ten: 540 is G54, 541 is G54.1.</param>
/// <param name="WorkOffsetNumber">The P word of the work offset; 0 if it has none.</param>
/// <param name="Origin">Origin of the work offset in machine coordinates, mm, as far as the program itself sets it (G10).</param>
/// <param name="UnknownOrigin">Axes in which only the machine knows the origin.</param>
/// <param name="Rotation">Rotation of the work offset about its origin in the XY plane, degrees (G10 L2 R); null if only the machine
/// knows it.</param>
/// <param name="Shift">Additional shift of the origin (G92, G52), mm.</param>
/// <param name="UnknownShift">Axes in which the shift is unknown.</param>
/// <param name="ProgramShift">Work coordinates minus programmed coordinates, mm, if the only program transformation is a shift (TRANS);
/// otherwise zero.</param>
/// <param name="IsTransformed">True if there is more than a shift: rotation, scaling, mirroring, polar or other transformations.</param>
public sealed record NcFrame(
    int Block,
    int WorkOffset,
    int WorkOffsetNumber,
    Vector3 Origin,
    AxisSet UnknownOrigin,
    double? Rotation,
    Vector3 Shift,
    AxisSet UnknownShift,
    Vector3 ProgramShift,
    bool IsTransformed);
