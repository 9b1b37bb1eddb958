namespace ErrorMatching.Cell;

/// <summary>Whether a job could start: its files can be read, and the program that it starts from can be followed to its end.</summary>
/// <param name="Job">The job.</param>
/// <param name="Program">The program that it starts from; null for a job that makes one.</param>
/// <param name="Motions">How many motions that program has; null if there is none or it cannot be followed.</param>
/// <param name="Problem">What is wrong; null if nothing is.</param>
public sealed record CheckedJob(CellJobSettings Job, string? Program, int? Motions, CheckProblem? Problem);
