using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A state that can be looked for.</summary>
/// <param name="State">The state; null for any.</param>
/// <param name="Name">Its name.</param>
public sealed record StateChoice(CorrectionState? State, string Name);
