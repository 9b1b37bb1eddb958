namespace ErrorMatching.Geometry;

/// <summary>One of the three coordinate planes. The axis order gives counterclockwise the same meaning on every control.</summary>
public enum CoordinatePlane
{
    /// <summary>X then Y, seen against Z (G17).</summary>
    XY,

    /// <summary>Z then X, seen against Y (G18).</summary>
    ZX,

    /// <summary>Y then Z, seen against X (G19).</summary>
    YZ,
}
