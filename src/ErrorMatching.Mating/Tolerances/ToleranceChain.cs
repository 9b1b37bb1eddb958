using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The dimensions that add up to a mating dimension, each with its limits and sign (Wang 2021, section 2.4).</summary>
/// <param name="Links">At least one dimension.</param>
public sealed record ToleranceChain(IReadOnlyList<ChainLink> Links)
{
    /// <summary>The signed sum of the nominal sizes.</summary>
    public double NominalMm => Links.Sum(l => l.Sign * l.NominalMm);

    /// <summary>The smallest and largest size with every dimension at its worst limit; a shortening dimension contributes its limits
    /// exchanged.</summary>
    public ChainDimension WorstCase()
    {
        var smallest = Links.Sum(l => l.Sign > 0 ? l.Tolerance.LowerMm : -l.Tolerance.UpperMm);
        var largest = Links.Sum(l => l.Sign > 0 ? l.Tolerance.UpperMm : -l.Tolerance.LowerMm);
        return new(NominalMm, new(smallest, largest));
    }

    /// <summary>The smallest and largest size if the dimensions vary independently: band centers add with their signs, half widths by
    /// root sum of squares.</summary>
    /// <remarks>Standard statistical tolerance analysis. If all bands cover the same probability and the dimensions are normally
    /// distributed about the band centers, the result covers that probability too.</remarks>
    public ChainDimension RootSumOfSquares()
    {
        var middle = Links.Sum(l => l.Sign * (l.Tolerance.LowerMm + l.Tolerance.UpperMm) / 2);
        var half = Math.Sqrt(Links.Sum(l => Square((l.Tolerance.UpperMm - l.Tolerance.LowerMm) / 2)));
        return new(NominalMm, new(middle - half, middle + half));
    }

    private static double Square(double value) => value * value;
}

/// <summary>One dimension of a tolerance chain.</summary>
/// <param name="Name">What it measures.</param>
/// <param name="NominalMm">Its nominal size.</param>
/// <param name="Tolerance">The limits of its deviation from nominal.</param>
/// <param name="Sign">1 if a larger dimension lengthens the chain, -1 if it shortens it.</param>
public sealed record ChainLink(string Name, double NominalMm, ToleranceBand Tolerance, int Sign);

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
