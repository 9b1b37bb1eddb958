namespace ErrorMatching.Cell;

/// <summary>The result of a measurement: <see cref="Identified"/> before it is computed, then a <see cref="ComputedProgram"/> or
/// <see cref="NothingToSend"/>; at any time a <see cref="RefusedComputation"/>.</summary>
public abstract record Computation;
