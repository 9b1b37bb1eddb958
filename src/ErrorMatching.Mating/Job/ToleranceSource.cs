namespace ErrorMatching.Mating;

/// <summary>Where the limits of a feature come from.</summary>
public enum ToleranceSource
{
    /// <summary>The job states them.</summary>
    Stated,

    /// <summary>The tolerance chain, every dimension at its worst.</summary>
    WorstCase,

    /// <summary>The tolerance chain by root sum of squares.</summary>
    RootSumOfSquares,
}
