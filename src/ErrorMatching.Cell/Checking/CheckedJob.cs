namespace ErrorMatching.Cell;

/// <summary>Whether a job could start: its files can be read, and its base program can be followed to its end.</summary>
/// <param name="Job">The job.</param>
/// <param name="Program">Its base program; null for a job that generates one.</param>
/// <param name="Motions">Number of motions in that program; null if there is none or it cannot be followed.</param>
/// <param name="Problem">What is wrong; null if nothing is.</param>
public sealed record CheckedJob(CellJobSettings Job, string? Program, int? Motions, CheckProblem? Problem);
