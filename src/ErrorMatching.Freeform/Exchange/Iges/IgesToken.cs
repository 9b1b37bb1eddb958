namespace ErrorMatching.Freeform;

/// <summary>One parameter of an IGES record: a range of the assembled text.</summary>
/// <param name="Start">Where it starts in the text.</param>
/// <param name="Length">Its length; 0 for a parameter left to its default.</param>
/// <param name="IsText">True for a string in Hollerith form (nH...), of which the range is what follows the H.</param>
internal readonly record struct IgesToken(int Start, int Length, bool IsText);
