namespace ErrorMatching.Hmi;

/// <summary>A step that a correction took, as it is shown.</summary>
/// <param name="Time">When.</param>
/// <param name="State">What it became.</param>
/// <param name="By">By whom.</param>
/// <param name="Basis">On what basis.</param>
public sealed record StepRow(string Time, string State, string By, string Basis);
