using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A set of the three linear axes.</summary>
[Flags]
public enum AxisSet : byte
{
    /// <summary>No axis.</summary>
    None = 0,

    /// <summary>The X axis.</summary>
    X = 1,

    /// <summary>The Y axis.</summary>
    Y = 2,

    /// <summary>The Z axis.</summary>
    Z = 4,

    /// <summary>All three.</summary>
    All = 7,
}

/// <summary>Relates sets of axes to planes and places.</summary>
internal static class AxisSetExtensions
{
    /// <summary>The two axes of a plane.</summary>
    public static AxisSet Axes(this CoordinatePlane plane) => plane switch
    {
        CoordinatePlane.ZX => AxisSet.Z | AxisSet.X,
        CoordinatePlane.YZ => AxisSet.Y | AxisSet.Z,
        _ => AxisSet.X | AxisSet.Y,
    };

    /// <summary>A place with the unknown coordinates read as zero.</summary>
    public static Point3 KnownPartOf(this AxisSet unknown, Point3 place) => unknown == AxisSet.None
        ? place
        : new(
            (unknown & AxisSet.X) == AxisSet.None ? place.X : 0,
            (unknown & AxisSet.Y) == AxisSet.None ? place.Y : 0,
            (unknown & AxisSet.Z) == AxisSet.None ? place.Z : 0);

    /// <summary>The axes in which a vector is not zero.</summary>
    public static AxisSet Axes(this Vector3 v) =>
        (v.X != 0 ? AxisSet.X : AxisSet.None) | (v.Y != 0 ? AxisSet.Y : AxisSet.None) | (v.Z != 0 ? AxisSet.Z : AxisSet.None);

    /// <summary>The part of a vector along these axes.</summary>
    public static Vector3 PartOf(this AxisSet axes, Vector3 v) => new(
        (axes & AxisSet.X) != AxisSet.None ? v.X : 0,
        (axes & AxisSet.Y) != AxisSet.None ? v.Y : 0,
        (axes & AxisSet.Z) != AxisSet.None ? v.Z : 0);
}
