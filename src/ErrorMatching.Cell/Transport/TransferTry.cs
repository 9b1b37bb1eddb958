namespace ErrorMatching.Cell;

/// <summary>A try that failed and is followed by another.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Number">Which try it was, from 1.</param>
/// <param name="Failure">Why it failed.</param>
/// <param name="Wait">How long until the next one.</param>
public sealed record TransferTry(string Machine, int Number, TransportException Failure, TimeSpan Wait);
