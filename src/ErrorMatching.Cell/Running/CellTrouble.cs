namespace ErrorMatching.Cell;

/// <summary>Something that keeps a part of a running cell from working.</summary>
/// <param name="Where">Which part: <c>slot MACHINE/SLOT</c>, <c>gauge NAME</c>, <c>store</c> or the name of a worker.</param>
/// <param name="Code">Stable word.</param>
/// <param name="Message">A sentence for whoever has to help.</param>
/// <param name="Since">Since when.</param>
public sealed record CellTrouble(string Where, string Code, string Message, DateTimeOffset Since);
