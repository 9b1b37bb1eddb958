namespace ErrorMatching.Cell;

/// <summary>A failed attempt that is followed by another.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Number">Number of the attempt, from 1.</param>
/// <param name="Failure">Why it failed.</param>
/// <param name="Wait">Delay until the next attempt.</param>
public sealed record TransferTry(string Machine, int Number, TransportException Failure, TimeSpan Wait);
