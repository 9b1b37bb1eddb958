namespace ErrorMatching.Cell;

/// <summary>Progress of a long operation on a store.</summary>
/// <param name="Doing">What is being done, in a few words.</param>
/// <param name="Done">The amount done.</param>
/// <param name="Of">The total; 0 if unknown.</param>
public readonly record struct CellProgress(string Doing, long Done, long Of);
