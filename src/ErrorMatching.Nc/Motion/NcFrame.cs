using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The layers between programmed coordinates and the machine, from one block on. A motion names its frame by number.</summary>
/// <param name="Block">Position of the block from which on it holds; 0 for the first.</param>
/// <param name="WorkOffset">The work offset as a code times ten: 540 is G54, 541 is G54.1.</param>
/// <param name="WorkOffsetNumber">The P word of the work offset, 0 where it has none.</param>
/// <param name="Origin">Place of the work offset in machine coordinates, mm, as far as the program itself sets it (G10).</param>
/// <param name="UnknownOrigin">Axes in which only the machine knows it.</param>
/// <param name="Rotation">Rotation of the work offset about its origin in the plane XY, degrees (G10 L2 R);
/// null where only the machine knows it.</param>
/// <param name="Shift">Shift of the origin on top (G92, G52), mm.</param>
/// <param name="UnknownShift">Axes in which the shift is not known.</param>
/// <param name="ProgramShift">Work coordinates less programmed ones, mm, where a programmable shift (TRANS) is all that lies on top;
/// else zero.</param>
/// <param name="IsTransformed">True if more than a shift lies on top: rotation, scale, mirror, polar or other transformations.</param>
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
