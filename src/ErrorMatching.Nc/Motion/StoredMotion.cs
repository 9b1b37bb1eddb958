using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A motion in 32 bytes, stored as its end. It begins at the end of the one before unless a start is stored. Values that many
/// motions share, or that only arcs have, are stored separately.</summary>
internal struct StoredMotion
{
    private const int KindShift = 24;
    private const int PlaneShift = 27;
    private const int UnknownShift = 29;

    public double X;
    public double Y;
    public double Z;
    public int Block;

    // Flags in 24 bits, then kind in 3, plane in 2, unknown axes in 3.
    private readonly uint _packed;

    public StoredMotion(int block, MotionKind kind, CoordinatePlane plane, MotionFlags flags, Point3 end, AxisSet unknownEnd)
    {
        (X, Y, Z, Block) = (end.X, end.Y, end.Z, block);
        _packed = (uint)flags | ((uint)kind << KindShift) | ((uint)plane << PlaneShift) | ((uint)unknownEnd << UnknownShift);
    }

    public readonly Point3 End => new(X, Y, Z);

    public readonly MotionFlags Flags => (MotionFlags)(_packed & 0xFFFFFF);

    public readonly MotionKind Kind => (MotionKind)((_packed >> KindShift) & 7);

    public readonly bool IsArc => Kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;

    public readonly CoordinatePlane Plane => (CoordinatePlane)((_packed >> PlaneShift) & 3);

    public readonly AxisSet UnknownEnd => (AxisSet)(_packed >> UnknownShift);

    /// <summary>True for a straight cut in the XY plane that begins at the end of the one before, ends at a known place and does not
    /// switch compensation.</summary>
    public readonly bool IsPlainCut =>
        Kind == MotionKind.Line
            && Plane == CoordinatePlane.XY
            && UnknownEnd == AxisSet.None
            && (Flags & (MotionFlags.StartsElsewhere | MotionFlags.CompensationSwitches)) == MotionFlags.None;

    /// <summary>True if both have the same kind, plane and flags, and the same axes of their ends are known.</summary>
    public readonly bool SameModes(in StoredMotion other) => _packed == other._packed;

    /// <summary>True if all values stored here, except the block, are bitwise equal.</summary>
    public readonly bool SameAs(in StoredMotion other) => _packed == other._packed && SamePlace(other);

    /// <summary>True if both end at bitwise the same place and the same axes of it are known.</summary>
    public readonly bool SameEnd(in StoredMotion other) => UnknownEnd == other.UnknownEnd && SamePlace(other);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly bool SamePlace(in StoredMotion other) =>
        Bits(X) == Bits(other.X) && Bits(Y) == Bits(other.Y) && Bits(Z) == Bits(other.Z);

    private static long Bits(double value) => BitConverter.DoubleToInt64Bits(value);
}
