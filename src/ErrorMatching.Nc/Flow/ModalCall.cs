namespace ErrorMatching.Nc;

/// <summary>A macro that is called after every motion (Fanuc G66).</summary>
/// <param name="Unit">The macro.</param>
/// <param name="Passes">Number of passes per call.</param>
/// <param name="Arguments">Values of its local variables in each call.</param>
internal sealed record ModalCall(FlowUnit Unit, long Passes, IReadOnlyList<(VariablePlace Place, NcValue Value)> Arguments);
