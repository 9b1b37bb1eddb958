namespace ErrorMatching.Mating;

/// <summary>A point whose measured position must match its design before anything is compared (Wang 2021, section 2.2).</summary>
/// <param name="Point">Label of the point in the theoretical and the measured file.</param>
/// <param name="LimitMm">The largest distance allowed.</param>
public sealed record JobOriginCheck(string Point, double LimitMm);
