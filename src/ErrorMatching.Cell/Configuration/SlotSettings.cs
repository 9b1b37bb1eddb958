namespace ErrorMatching.Cell;

/// <summary>A place at a machine that holds one program at a time.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Program">Name of the program at the machine. The programs of all slots form the whitelist: nothing else is ever
/// written.</param>
/// <param name="ReadyFile">Name of the file by which the machine reports that the piece is cut; null if an operator reports it.</param>
public sealed record SlotSettings(string Name, string Program, string? ReadyFile);
