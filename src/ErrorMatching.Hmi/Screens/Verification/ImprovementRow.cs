namespace ErrorMatching.Hmi;

/// <summary>A quantity of a feature before and after, as it is shown.</summary>
/// <param name="Feature">Its feature or comparison.</param>
/// <param name="Quantity">What is compared, with the points of a comparison.</param>
/// <param name="Wanted">The part's value; a dash for deviations, which are from the part.</param>
/// <param name="Before">That of the counterpart without compensation; a deviation is that of the point that is furthest off, with its sign: counterpart - part.</param>
/// <param name="After">That of the counterpart with it, likewise.</param>
/// <param name="Improvement">By how much of the error before the error after is smaller, or in words that it is larger, and by how much.</param>
/// <param name="Unit">mm or degrees.</param>
/// <param name="IsWorse">True if the error is larger than before.</param>
public sealed record ImprovementRow(string Feature, string Quantity, string Wanted, string Before, string After, string Improvement, string Unit, bool IsWorse);
