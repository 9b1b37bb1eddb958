namespace ErrorMatching.Cell;

/// <summary>How far long work on a store is.</summary>
/// <param name="Doing">What is being done, in a few words.</param>
/// <param name="Done">How much of it is done.</param>
/// <param name="Of">Of how much; 0 where nobody knows.</param>
public readonly record struct CellProgress(string Doing, long Done, long Of);
