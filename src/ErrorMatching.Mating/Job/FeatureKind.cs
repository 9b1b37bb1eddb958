namespace ErrorMatching.Mating;

/// <summary>The shapes of a mating boundary (Wang 2021, section 2.1).</summary>
public enum FeatureKind
{
    /// <summary>A straight line.</summary>
    Line,

    /// <summary>A notch or a ridge of two straight flanks.</summary>
    Triangle,

    /// <summary>A hill or a valley.</summary>
    Curve,
}
