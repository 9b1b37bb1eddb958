namespace ErrorMatching.Nc;

/// <summary>A note on how a program was read: something that another machine could read differently, or control behavior that is not
/// followed. The program itself is not wrong.</summary>
/// <param name="Code">A stable identifier.</param>
/// <param name="Block">Position of the first block concerned, from 0.</param>
/// <param name="Count">Number of occurrences while the program ran.</param>
/// <param name="Message">What was found and how it was read, in a sentence.</param>
public sealed record NcNote(string Code, int Block, long Count, string Message);
