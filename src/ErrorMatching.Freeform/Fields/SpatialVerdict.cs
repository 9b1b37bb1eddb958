namespace ErrorMatching.Freeform;

/// <summary>What neighbors say about measured errors.</summary>
public enum SpatialVerdict
{
    /// <summary>Neighbors are alike beyond chance: the errors have a systematic part, which the mirror can take away.</summary>
    Systematic,

    /// <summary>Neighbors are no more alike than chance makes them: mirroring would cut noise into the surface.</summary>
    Noise,

    /// <summary>Too few points, or all errors the same.</summary>
    Undetermined,
}
