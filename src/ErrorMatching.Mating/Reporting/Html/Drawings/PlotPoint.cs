using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point in a plot of mating errors (counterpart - part along the normal; positive overlaps, negative leaves a
/// gap).</summary>
/// <param name="Label">Its label.</param>
/// <param name="Feature">Name of its feature; empty if unknown.</param>
/// <param name="Before">The mating error without compensation.</param>
/// <param name="After">The mating error with it.</param>
/// <param name="Limits">The limits of the mating error; null if there are none.</param>
internal sealed record PlotPoint(string Label, string Feature, double Before, double After, ToleranceBand? Limits)
{
    /// <summary>Half the 95 % interval about both errors; null if it is not known.</summary>
    public double? Interval95Mm { get; init; }
}

/// <summary>The worst place between the key points of a feature, in a plot of mating errors.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Index">Where it lies among the points of the plot; between two of them it is a fraction.</param>
/// <param name="After">The mating error with compensation.</param>
/// <param name="Interval95Mm">Half its 95 % interval.</param>
/// <param name="Place">The place in words.</param>
internal sealed record PlotPlace(string Feature, double Index, double After, double Interval95Mm, string Place);
