namespace ErrorMatching.Freeform;

/// <summary>Whether measured errors are systematic, judged by neighboring points.</summary>
public enum SpatialVerdict
{
    /// <summary>Neighbors are alike beyond chance: the errors have a systematic part, which mirroring can remove.</summary>
    Systematic,

    /// <summary>Neighbors are no more alike than by chance: mirroring would cut noise into the surface.</summary>
    Noise,

    /// <summary>Too few points, or all errors are equal.</summary>
    Undetermined,
}
