namespace ErrorMatching.Nc;

/// <summary>The state of a run before a block.</summary>
/// <param name="State">Modes and the tool's place.</param>
/// <param name="Variables">All variables.</param>
/// <param name="Motions">Number of motions so far.</param>
/// <param name="Problems">Number of problems so far.</param>
/// <param name="MachineWrites">Number of times the program wrote machine data.</param>
internal sealed record WayStep(
    ModalState State, Dictionary<VariableKey, NcValue> Variables, int Motions, int Problems, long MachineWrites)
{
    /// <summary>True if the control is in the same state as in the other step, but for variables.</summary>
    public bool IsAs(WayStep other)
    {
        var (state, otherState) = (State, other.State);
        state.Position = state.Unknown.KnownPartOf(state.Position);
        otherState.Position = otherState.Unknown.KnownPartOf(otherState.Position);
        return state.SameAs(otherState) && Problems == other.Problems && MachineWrites == other.MachineWrites;
    }

    /// <summary>The variables that differ.</summary>
    public VariableKey[] DifferencesFrom(WayStep other) =>
    [
        .. Variables.Keys.Union(other.Variables.Keys)
            .Where(k => !Variables.TryGetValue(k, out var own) || !other.Variables.TryGetValue(k, out var its) || !own.Equals(its)),
    ];
}
