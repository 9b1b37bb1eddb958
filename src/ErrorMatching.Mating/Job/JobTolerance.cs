using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>The limits of a feature's deviation: the part's actual - theoretical along the normal that points from the counterpart's
/// material to its tool.</summary>
/// <param name="Band">The limits.</param>
/// <param name="Source">Where they come from.</param>
public sealed record JobTolerance(ToleranceBand Band, ToleranceSource Source)
{
    /// <summary>Where the job states them; null for limits that are in no file.</summary>
    public JsonPlace? Place { get; init; }
}
