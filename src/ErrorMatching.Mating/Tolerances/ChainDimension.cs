namespace ErrorMatching.Mating;

/// <summary>The total dimension of a tolerance chain.</summary>
/// <param name="NominalMm">Its nominal size.</param>
/// <param name="Band">The limits of its deviation from nominal.</param>
public readonly record struct ChainDimension(double NominalMm, ToleranceBand Band)
{
    /// <summary>Its smallest size.</summary>
    public double SmallestMm => NominalMm + Band.LowerMm;

    /// <summary>Its largest size.</summary>
    public double LargestMm => NominalMm + Band.UpperMm;
}
