namespace ErrorMatching.Cell;

/// <summary>The state of the store, found without creating or changing it.</summary>
/// <param name="IsThere">True if it exists.</param>
/// <param name="Form">Its schema version, from 1; 0 if it has none yet.</param>
/// <param name="Latest">The schema version that this program migrates it to on opening.</param>
/// <param name="Problem">Why it could not be examined; null if it could.</param>
public sealed record CheckedStore(bool IsThere, long Form, long Latest, CheckProblem? Problem);
