namespace ErrorMatching.Cell;

/// <summary>What a login to a machine and a listing of its folder came to.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Names">What is in its folder; null if it could not be listed.</param>
/// <param name="NeedsPassword">True if its transport signs in by a password.</param>
/// <param name="Untried">What could not be tried without changing something there, a sentence; null if it could not be listed.</param>
/// <param name="Problem">Why it could not be listed; null if it was.</param>
public sealed record CheckedMachine(MachineSettings Machine, IReadOnlyList<string>? Names, bool NeedsPassword, string? Untried, CheckProblem? Problem);
