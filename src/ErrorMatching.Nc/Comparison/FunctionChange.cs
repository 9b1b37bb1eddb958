namespace ErrorMatching.Nc;

/// <summary>Words that move nothing and differ between two programs: tools, spindle, offsets, stops, variables.</summary>
/// <param name="Before">All such words of the first program since its previous motion, normalized (<c>M6</c> for M06), in order.</param>
/// <param name="After">Those of the second program.</param>
public sealed record FunctionChange(IReadOnlyList<string> Before, IReadOnlyList<string> After);
