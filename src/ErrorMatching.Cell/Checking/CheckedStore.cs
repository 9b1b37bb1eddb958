namespace ErrorMatching.Cell;

/// <summary>What the store looks like, without making or changing it.</summary>
/// <param name="IsThere">True if it is there.</param>
/// <param name="Form">Number of its form, from 1; 0 if it has none yet.</param>
/// <param name="Latest">Number of the form that this program takes it to when it is opened.</param>
/// <param name="Problem">Why it cannot be looked at; null if it could.</param>
public sealed record CheckedStore(bool IsThere, long Form, long Latest, CheckProblem? Problem);
