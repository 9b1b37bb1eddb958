using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Lets a program at a machine be replaced or removed only while the machine is idle or runs another program. A held or alarmed
/// program counts as running, and so does one of an unknown state.</summary>
/// <remarks>A control has no lock that the cell could take. So the state is asked immediately before the replacement and again after it:
/// a machine that started in between is noticed, not prevented.</remarks>
public sealed class ReplacementGuard
{
    private readonly MachineSettings _machine;
    private readonly StateSettings _settings;
    private readonly MachineStateSource _source;

    private ReplacementGuard(MachineSettings machine, StateSettings settings, TimeProvider clock) =>
        (_machine, _settings, _source) = (machine, settings, settings.Open(clock));

    /// <summary>The guard of a machine; null if nothing says what the machine is doing.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="clock">The clock.</param>
    public static ReplacementGuard? Of(MachineSettings machine, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(machine);
        ArgumentNullException.ThrowIfNull(clock);
        return machine.State is { } settings ? new(machine, settings, clock) : null;
    }

    /// <summary>Asks the machine.</summary>
    /// <param name="cancellation">Cancels immediately.</param>
    public Task<MachineState> AskAsync(CancellationToken cancellation) => _source.AskAsync(cancellation);

    /// <summary>Asks whether a program may be replaced now.</summary>
    /// <param name="program">Its name at the machine.</param>
    /// <param name="contents">What it contains there, and what it is to contain: the machine may call it by either. Null for
    /// nothing.</param>
    /// <param name="cancellation">Cancels immediately.</param>
    /// <returns>Why not; null if it may.</returns>
    public async Task<Statement?> WhyNotAsync(
        string program, IReadOnlyCollection<ReadOnlyMemory<byte>?> contents, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(contents);
        var state = await AskAsync(cancellation).ConfigureAwait(false);
        return MayReplace(state, MachinePrograms.Identify(_machine, program, contents)) ? null : Why(state, program);
    }

    /// <summary>Asks whether a program may be replaced now, and reads its contents only if the answer depends on them.</summary>
    internal async Task<Statement?> WhyNotAsync(
        string program,
        Func<CancellationToken, Task<IReadOnlyCollection<ReadOnlyMemory<byte>?>>> contents,
        CancellationToken cancellation)
    {
        var state = await AskAsync(cancellation).ConfigureAwait(false);
        if (state.Activity == MachineActivity.Idle)
            return null;
        return state.Activity != MachineActivity.Unknown && !_settings.OnlyIdle
            && !state.Uses(MachinePrograms.Identify(_machine, program, await contents(cancellation).ConfigureAwait(false)))
            ? null
            : Why(state, program);
    }

    /// <summary>Demands that a program may be replaced now.</summary>
    /// <exception cref="MachineBusyException">It may not.</exception>
    internal async Task DemandAsync(
        string program, IReadOnlyCollection<ReadOnlyMemory<byte>?> contents, CancellationToken cancellation)
    {
        if (await WhyNotAsync(program, contents, cancellation).ConfigureAwait(false) is { } why)
            throw new MachineBusyException(why, isReplaced: false);
    }

    /// <summary>Asks after a replacement whether the machine started the program meanwhile.</summary>
    /// <returns>Null if it did not; why that is unknown if the machine does not say.</returns>
    /// <exception cref="MachineBusyException">It did: nobody knows whether it runs the old program or the new one.</exception>
    internal async Task<Statement?> AfterAsync(
        string program, IReadOnlyCollection<ReadOnlyMemory<byte>?> contents, CancellationToken cancellation)
    {
        var state = await AskAsync(cancellation).ConfigureAwait(false);
        return state.Activity == MachineActivity.Unknown ? state.Why
            : state.Uses(MachinePrograms.Identify(_machine, program, contents))
                ? throw new MachineBusyException(Recorded.StartedMeanwhile.With(_machine.Name, program), isReplaced: true)
            : null;
    }

    private bool MayReplace(MachineState state, ProgramIdentity program) =>
        _settings.OnlyIdle ? state.Activity == MachineActivity.Idle : !state.Uses(program);

    private Statement Why(MachineState state, string program) => state switch
    {
        { Activity: MachineActivity.Unknown } => Recorded.MachineUnknown.With(_machine.Name, program, state.Why),
        { Programs: [_, ..] } => Recorded.MachineBusy.With(_machine.Name, Word(state.Activity), state.Named, program),
        _ => Recorded.MachineBusyUnnamed.With(_machine.Name, Word(state.Activity), program),
    };

    private static string Word(MachineActivity activity) => activity.ToString().ToLowerInvariant();
}

/// <summary>A program must not be replaced now, or was replaced while its machine started it.</summary>
/// <param name="why">A sentence for a setter.</param>
/// <param name="isReplaced">True if it was replaced: the machine may run the old program or the new one.</param>
public sealed class MachineBusyException(Statement why, bool isReplaced) : Exception(why?.Sentence)
{
    /// <summary>The message as it is recorded.</summary>
    public Statement Statement => why;

    /// <summary>True if the program was replaced.</summary>
    public bool IsReplaced => isReplaced;
}
