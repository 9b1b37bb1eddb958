namespace ErrorMatching.Hmi;

/// <summary>A step in a correction's history.</summary>
/// <param name="Time">Its time.</param>
/// <param name="State">The new state.</param>
/// <param name="By">Who took it.</param>
/// <param name="Basis">Its basis.</param>
internal sealed record StepRow(string Time, string State, string By, string Basis);
