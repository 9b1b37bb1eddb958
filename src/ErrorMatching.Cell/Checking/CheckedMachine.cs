namespace ErrorMatching.Cell;

/// <summary>The result of logging in to a machine and listing its folder.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Names">The names in its folder; null if it could not be listed.</param>
/// <param name="NeedsPassword">True if its transport signs in with a password.</param>
/// <param name="Untried">A sentence on what could not be tested without changing something at the machine; null if it could not be
/// listed.</param>
/// <param name="Problem">Why it could not be listed; null if it was.</param>
public sealed record CheckedMachine(
    MachineSettings Machine, IReadOnlyList<string>? Names, bool NeedsPassword, string? Untried, CheckProblem? Problem);
