namespace ErrorMatching.Cell;

/// <summary>Signs in to machines and lists their folders.</summary>
internal sealed class MachineCheck(CellSettings settings, CheckedStore store)
{
    public const string SecretMissing = "secret-missing";
    public const string KeyMissing = "key-missing";

    public async Task<IReadOnlyList<CheckedMachine>> OfAllAsync(Action<CheckedMachine> looked, CancellationToken cancellation)
    {
        // Opening a store with an earlier schema version would change it.
        using var opened = store.IsThere && store.Form == store.Latest && settings.Machines.Any(m => m.NeedsPassword)
            ? CellStore.Open(settings.Store, TimeProvider.System, inspect: false)
            : null;
        return await Task.WhenAll(settings.Machines.Select(Ask)).ConfigureAwait(false);

        async Task<CheckedMachine> Ask(MachineSettings machine)
        {
            var found = await OfAsync(machine, opened, cancellation).ConfigureAwait(false);
            looked(found);
            return found;
        }
    }

    private async Task<CheckedMachine> OfAsync(MachineSettings machine, CellStore? opened, CancellationToken cancellation)
    {
        string? secret = null;
        try
        {
            if (machine.NeedsPassword)
            {
                secret = opened is null ? null : new MachineSecrets(opened, settings.KeysFolder).Get(machine.Name);
                if (secret is null)
                {
                    var why = opened is null ? "the store, which keeps it, is not there yet or has another form" : "none is kept";
                    return Problem(
                        SecretMissing,
                        $"{machine.Name}: its password is missing, for {why}. Set it: errormatch cell secret {settings.File} "
                            + $"{machine.Name} --user NAME.");
                }
            }

            if (machine.Transport.SignInKey is { } key && !File.Exists(key))
            {
                return Problem(
                    KeyMissing,
                    $"{machine.Name}: there is no key {key} to sign in with. Name the private key whose public half the server knows.");
            }

            using var folder = MachineFolders.Open(machine, () => secret);
            var names = await folder.ListAsync(cancellation).ConfigureAwait(false);
            return await WithStateAsync(new(machine, names, machine.NeedsPassword, Untried(machine), null), cancellation)
                .ConfigureAwait(false);
        }
        catch (TransportException e)
        {
            return Problem(CellCodes.Of(e.Error), e.Message);
        }
        catch (PeopleException e)
        {
            return Problem(SecretMissing, $"{machine.Name}: {e.Message}");
        }

        CheckedMachine Problem(string code, string message) =>
            new(machine, null, machine.NeedsPassword, null, CheckProblem.Of(code, message));
    }

    private static async Task<CheckedMachine> WithStateAsync(CheckedMachine machine, CancellationToken cancellation)
    {
        if (ReplacementGuard.Of(machine.Machine, TimeProvider.System) is not { } guard)
        {
            return machine;
        }

        var state = await guard.AskAsync(cancellation).ConfigureAwait(false);
        return machine with { State = state, Problem = state is { Code: { } code, Why: { } why } ? new([new(code, why.Sentence)]) : null };
    }

    private string Untried(MachineSettings machine)
    {
        var logs = settings.Gauges.Any(g => g.Machine == machine.Name && !g.KeepsFile)
            ? ", nor whether logs may be renamed and deleted"
            : "";
        return $"{machine.Name}: whether programs may be written, renamed and deleted there was not tried, for that changes "
            + $"something{logs}. The first program shows it; until then the control keeps what it has.";
    }
}

/// <summary>The result of logging in to a machine and listing its folder.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Names">The names in its folder; null if it could not be listed.</param>
/// <param name="NeedsPassword">True if its transport signs in with a password.</param>
/// <param name="Untried">A sentence on what could not be tested without changing something at the machine; null if it could not be
/// listed.</param>
/// <param name="Problem">Why it could not be listed, or why it does not say what it is doing; null if nothing is wrong.</param>
public sealed record CheckedMachine(
    MachineSettings Machine, IReadOnlyList<string>? Names, bool NeedsPassword, string? Untried, CheckProblem? Problem)
{
    /// <summary>What the machine is doing; null if nothing says that, or if its folder could not be listed.</summary>
    public MachineState? State { get; init; }
}
