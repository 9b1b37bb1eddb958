namespace ErrorMatching.Cell;

/// <summary>A place at a machine for one program at a time.</summary>
/// <param name="Name">What people call it.</param>
/// <param name="Program">Name of the program there. The programs of all slots are the white list: nothing else is ever written.</param>
/// <param name="ReadyFile">Name of a file by which the machine says that the piece is cut; null if an operator says so.</param>
public sealed record SlotSettings(string Name, string Program, string? ReadyFile);
