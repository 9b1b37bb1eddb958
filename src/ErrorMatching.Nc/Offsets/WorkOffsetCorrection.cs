namespace ErrorMatching.Nc;

/// <summary>A correction of a work offset: a turn about its origin, and a shift, both in the XY plane.</summary>
/// <param name="Number">Number of the work offset; 1 for the control's first one (G54).</param>
/// <param name="Total">The correction in all.</param>
/// <param name="Before">The correction that must be there before; null if any may be.</param>
public sealed record WorkOffsetCorrection(int Number, OffsetShift Total, OffsetShift? Before);

/// <summary>A turn about the origin, then a shift, in the XY plane.</summary>
/// <param name="XMm">Shift in X, mm.</param>
/// <param name="YMm">Shift in Y, mm.</param>
/// <param name="RotationDegrees">Turn, degrees, counterclockwise.</param>
public readonly record struct OffsetShift(decimal XMm, decimal YMm, decimal RotationDegrees);
