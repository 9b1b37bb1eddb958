namespace ErrorMatching.Mating;

/// <summary>The source of a feature's limits.</summary>
public enum ToleranceSource
{
    /// <summary>The job states them.</summary>
    Stated,

    /// <summary>The tolerance chain, with every dimension at its worst limit.</summary>
    WorstCase,

    /// <summary>The tolerance chain by root sum of squares.</summary>
    RootSumOfSquares,
}
