using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Sets of axes against planes and places.</summary>
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
        : new((unknown & AxisSet.X) == AxisSet.None ? place.X : 0, (unknown & AxisSet.Y) == AxisSet.None ? place.Y : 0, (unknown & AxisSet.Z) == AxisSet.None ? place.Z : 0);
}
