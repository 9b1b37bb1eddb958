using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>What one of several tests of structure found.</summary>
/// <param name="Kind">The structure it looks for.</param>
/// <param name="P">Probability that noise makes any of the tests as sure as this one is. The test has found a structure if it is at most
/// <see cref="SpatialStructure.Level"/>.</param>
public sealed record StructureTest(StructureKind Kind, double P)
{
    /// <summary>Of neighbors: true if they are opposite, false if they are alike.</summary>
    public bool IsOpposite { get; init; }

    /// <summary>Of the strongest wave: its length along u and along v in millimeters, infinite if it is constant in that direction. NaN
    /// for other tests, and where the places are not known in millimeters.</summary>
    public (double U, double V) WaveMm { get; init; } = (double.NaN, double.NaN);

    /// <summary>Of the strongest wave: the number of waves over the range of the places along u and along v.</summary>
    internal (double U, double V) Waves { get; init; } = (double.NaN, double.NaN);

    /// <summary>A probability to follow the letter p, with at most four decimals; smaller values are written as "less than".</summary>
    internal static string Words(double p) => p < 0.0001 ? "< 0.0001" : p.ToString("0.####", CultureInfo.InvariantCulture);
}

/// <summary>A kind of structure that one test looks for.</summary>
public enum StructureKind
{
    /// <summary>Neighbors are alike, or opposite (Moran's I, two-sided).</summary>
    Neighbors,

    /// <summary>The values follow a plane.</summary>
    Plane,

    /// <summary>The values follow a quadratic in u and v.</summary>
    Quadratic,

    /// <summary>The values follow a wave along u, along v or both.</summary>
    Wave,

    /// <summary>The values scatter more than the stated uncertainty of a point explains. Tested of few points only.</summary>
    Scatter,
}
