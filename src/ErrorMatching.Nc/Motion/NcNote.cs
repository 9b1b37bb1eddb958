namespace ErrorMatching.Nc;

/// <summary>What must be known of how a program was read: what another machine could read differently, and what the control does that is
/// not followed. Nothing is wrong with the program.</summary>
/// <param name="Code">A stable word.</param>
/// <param name="Block">Position of the first block that has it, from 0.</param>
/// <param name="Count">How often it was met while the program ran.</param>
/// <param name="Message">What was met and how it was read, in a sentence.</param>
public sealed record NcNote(string Code, int Block, long Count, string Message);
