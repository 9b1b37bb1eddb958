using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>The limits of a feature's deviation: actual - theoretical of the part, along the normal from the counterpart's material to
/// its tool.</summary>
/// <param name="Band">The limits.</param>
/// <param name="Source">Their source.</param>
public sealed record JobTolerance(ToleranceBand Band, ToleranceSource Source)
{
    /// <summary>Where the job states them; null for limits that are not in a file.</summary>
    public JsonPlace? Place { get; init; }
}

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
