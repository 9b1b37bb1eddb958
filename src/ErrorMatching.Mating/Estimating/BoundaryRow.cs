namespace ErrorMatching.Mating;

/// <summary>What one key point says about the deviations of elements: their weighted sum is the measured value.</summary>
/// <param name="Terms">One term for a point beside an element, two in the round of a corner.</param>
/// <param name="ValueMm">The measured value, from the counterpart's material to its tool.</param>
internal sealed record BoundaryRow(IReadOnlyList<RowTerm> Terms, double ValueMm);

/// <summary>A share of a row.</summary>
/// <param name="Element">Index of the element.</param>
/// <param name="AlongMm">Place on it: length along the boundary.</param>
/// <param name="Weight">The weight.</param>
internal sealed record RowTerm(int Element, double AlongMm, double Weight);
