namespace ErrorMatching.Freeform;

/// <summary>One parameter of an IGES record, as a range of the assembled text.</summary>
/// <param name="Start">Where it starts in the text.</param>
/// <param name="Length">Its length; 0 for an omitted parameter.</param>
/// <param name="IsText">True for a Hollerith string (nH...); the range is the text after the H.</param>
internal readonly record struct IgesToken(int Start, int Length, bool IsText);
