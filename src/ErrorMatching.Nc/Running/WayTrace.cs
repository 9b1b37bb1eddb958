namespace ErrorMatching.Nc;

/// <summary>What happens on one way of a branch.</summary>
internal sealed class WayTrace
{
    private readonly Dictionary<string, WayStep> _first = new(StringComparer.Ordinal);

    /// <summary>Number of motions before the branch.</summary>
    public int FirstMotion { get; init; }

    /// <summary>The motions of the run that took this way.</summary>
    public required NcMotions Motions { get; init; }

    /// <summary>True if the way led to the end of the program.</summary>
    public bool Ends { get; set; }

    /// <summary>The step at which it met the other way, and that way's step; null if it did not.</summary>
    public (WayStep Own, WayStep Other)? Meets { get; set; }

    /// <summary>Keeps a step, the first time that the run is there.</summary>
    public void Add(string place, WayStep step) => _first.TryAdd(place, step);

    /// <summary>The step at which the run was first at a place.</summary>
    public WayStep? At(string place) => _first.GetValueOrDefault(place);

    /// <summary>The motions from the branch up to a step.</summary>
    public NcMotion[] Until(int motions) => [.. Enumerable.Range(FirstMotion, motions - FirstMotion).Select(i => Motions[i])];
}

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
