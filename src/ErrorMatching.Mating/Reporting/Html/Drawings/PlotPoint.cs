namespace ErrorMatching.Mating;

/// <summary>A key point in a plot of mating errors (counterpart - part along the normal; positive overlaps, negative leaves a
/// gap).</summary>
/// <param name="Label">Its label.</param>
/// <param name="Feature">Name of its feature; empty if unknown.</param>
/// <param name="Before">The mating error without compensation.</param>
/// <param name="After">The mating error with it.</param>
/// <param name="Limits">The limits of the mating error; null if there are none.</param>
internal sealed record PlotPoint(string Label, string Feature, double Before, double After, ToleranceBand? Limits);
