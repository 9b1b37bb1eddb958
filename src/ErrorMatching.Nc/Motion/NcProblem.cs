namespace ErrorMatching.Nc;

/// <summary>Something in a program that the interpreter did not understand or considers wrong. The program stays unchanged.</summary>
/// <param name="Code">A stable identifier.</param>
/// <param name="Block">Position of the block, from 0.</param>
/// <param name="Message">What was found.</param>
public sealed record NcProblem(string Code, int Block, string Message);
