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
