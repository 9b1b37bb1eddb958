namespace ErrorMatching.Geometry;

/// <summary>The free motions of a best-fit alignment; all others are locked.</summary>
[Flags]
public enum AlignmentFreedom
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>Translation along x.</summary>
    X = 1,

    /// <summary>Translation along y.</summary>
    Y = 2,

    /// <summary>Rotation (about the origin of the frame, before the translation).</summary>
    Rotation = 4,

    /// <summary>Translation and rotation.</summary>
    All = X | Y | Rotation,
}
