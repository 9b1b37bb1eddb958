using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Checks periodically whether a machine or a gauge responds, so that a failure is known before something must be sent. Each
/// change is reported as a trouble, and once in the audit trail.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="where">The trouble's part, such as <see cref="CellTrouble.OfMachine"/>.</param>
/// <param name="name">Name of the machine or gauge.</param>
/// <param name="ask">Checks it; null if it responds.</param>
/// <param name="isTold">Whether a worker that uses it already reports the same problem.</param>
internal sealed class AnswerWatch(
    CellFlow flow, string where, string name, Func<CancellationToken, Task<AnswerProblem?>> ask,
    Func<AnswerProblem, CellTrouble, bool> isTold)
{
    private string? _code;

    /// <summary>Checks once.</summary>
    /// <returns>How long to wait before the next check.</returns>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        var problem = await ask(stop);
        if (problem?.Code != _code)
        {
            flow.Store.Audit(
                CellFlow.ByCell,
                problem is null ? CellCodes.AnswersAgain : CellCodes.NoAnswer,
                problem?.Message ?? Recorded.AnswersAgain.With(name),
                name);
            _code = problem?.Code;
        }

        if (problem is null || flow.Troubles.Open.Any(t => t.Where != where && isTold(problem, t)))
        {
            if (flow.Troubles.End(where) && problem is null)
            {
                flow.Log.Information("{Where}: answers again", where);
            }
        }
        else if (flow.Troubles.Begin(where, problem.Code, problem.Message))
        {
            flow.Log.Warning("{Where}: {Code}: {Message}", where, problem.Code, problem.Message.Sentence);
        }

        return problem?.IsOfLogin == true ? flow.Pace.Held : flow.Pace.Answer;
    }

    /// <summary>The watch of a machine: logs in, and lists its folder.</summary>
    public static AnswerWatch OfMachine(CellFlow flow, MachineSettings machine, IMachineFolder folder) => new(
        flow, CellTrouble.OfMachine(machine.Name), machine.Name, c => MachineAnswer.OfAsync(machine, folder, c),
        (p, t) => t.Code == p.Code && machine.Slots.Any(s => t.Where == CellTrouble.OfSlot(machine.Name, s.Name)));

    /// <summary>The watch of what says what a machine is doing. A machine that says that it does not know answers, too.</summary>
    public static AnswerWatch OfState(CellFlow flow, MachineSettings machine, ReplacementGuard guard) => new(
        flow, CellTrouble.OfState(machine.Name), machine.State!.Address,
        async c => await guard.AskAsync(c) is { Code: { } code, Why: { } why } ? new(code, why) : null, (_, _) => false);

    /// <summary>The watch of a gauge's folder.</summary>
    public static AnswerWatch OfGauge(CellFlow flow, GaugeSettings gauge) => new(
        flow, CellTrouble.OfFolder(gauge.Name), gauge.Name, new GaugeAnswer(gauge, flow.Clock).OfAsync,
        (_, t) => t.Where == CellTrouble.OfGauge(gauge.Name));
}

/// <summary>Why a machine or a gauge does not respond.</summary>
/// <param name="Code">Stable code.</param>
/// <param name="Message">A sentence for the person who has to fix it.</param>
/// <param name="IsOfLogin">True if the login was refused: controls lock a login after repeated attempts.</param>
internal sealed record AnswerProblem(string Code, Statement Message, bool IsOfLogin = false);

/// <summary>Checks whether a machine responds, without changing anything there.</summary>
internal static class MachineAnswer
{
    /// <summary>Checks the machine.</summary>
    /// <returns>Null if it responds.</returns>
    public static async Task<AnswerProblem?> OfAsync(MachineSettings machine, IMachineFolder folder, CancellationToken cancellation)
    {
        try
        {
            await folder.ListAsync(cancellation);

            // Programs are written there. A server tells whether that is possible only when one is written.
            return machine is { Transport.LocalFolder: { } path, Slots.Count: > 0 } && OperatingSystem.IsLinux()
                && LinuxCalls.WhyNotWritable(path) is { } why
                ? Problem(TransportFailure.Of(TransportError.Denied, machine.Name, $"looking whether programs may be written into {path}",
                    why.Message))
                : null;
        }
        catch (TransportException e)
        {
            return Problem(e);
        }
    }

    private static AnswerProblem Problem(TransportException e) =>
        new(CellCodes.Of(e.Error), e.Message, e.Error is TransportError.Login or TransportError.WrongServer);
}

/// <summary>Checks whether files in a gauge's folder can be seen and moved out, without changing anything there.</summary>
/// <param name="gauge">The gauge, with a folder.</param>
/// <param name="clock">Measures how long a share has hung.</param>
internal sealed class GaugeAnswer(GaugeSettings gauge, TimeProvider clock)
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(20);
    private Task<AnswerProblem?>? _asking;

    /// <summary>Checks the folder.</summary>
    /// <returns>Null if it responds.</returns>
    public async Task<AnswerProblem?> OfAsync(CancellationToken cancellation)
    {
        // A share that hangs blocks one thread in total, not another one each time.
        if (_asking is not { IsCompleted: false })
        {
            _asking = Task.Run(Look, CancellationToken.None);
        }

        try
        {
            return await _asking.WaitAsync(Limit, clock, cancellation);
        }
        catch (TimeoutException)
        {
            return new(CellCodes.GaugeAway, Sentence(FormattableString.Invariant($"nothing came within {Limit.TotalSeconds:0} s")));
        }
    }

    private AnswerProblem? Look()
    {
        var folder = gauge.Incoming!;
        try
        {
            using (var items = Directory.EnumerateFileSystemEntries(folder).GetEnumerator())
            {
                items.MoveNext();
            }

            using var aside = PinnedFolder.Open(Path.Combine(folder, ClaimFolder.Name));
            var places = aside is null ? new[] { folder } : [folder, aside.Path];
            return OperatingSystem.IsLinux() && places.Select(LinuxCalls.WhyNotWritable).FirstOrDefault(w => w is not null) is { } why
                ? new(
                    CellCodes.GaugeDenied,
                    $"Files cannot be taken out of the folder {folder} of the gauge \"{gauge.Name}\": {why.Message.TrimEnd('.')}. "
                    + "Give it to the user that the cell runs as.")
                : null;
        }
        catch (NotPlainFolderException e)
        {
            return new(CellCodes.GaugeDenied,
                $"Nothing is taken out of the folder of the gauge \"{gauge.Name}\": {e.Message.TrimEnd('.')}.");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return new(CellCodes.GaugeAway, Sentence(e.Message.TrimEnd('.')));
        }
    }

    private string Sentence(string why) =>
        $"The folder {gauge.Incoming} of the gauge \"{gauge.Name}\" cannot be looked into: {why}. "
        + "Is it there, is the share mounted, and may this user read it?";
}
