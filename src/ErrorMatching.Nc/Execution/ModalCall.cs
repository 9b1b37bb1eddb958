namespace ErrorMatching.Nc;

/// <summary>A macro that is called behind every motion (Fanuc G66).</summary>
/// <param name="Unit">The macro.</param>
/// <param name="Passes">How often each call executes it.</param>
/// <param name="Arguments">What each call gives to its local variables.</param>
internal sealed record ModalCall(FlowUnit Unit, long Passes, IReadOnlyList<(VariablePlace Place, NcValue Value)> Arguments);
