namespace ErrorMatching.Cell;

/// <summary>
/// Asks a machine or a gauge from time to time whether it answers, so that one that is gone is known before something must be sent. Each
/// change is told as a trouble, and once in the audit trail.
/// </summary>
/// <param name="flow">What workers share.</param>
/// <param name="where">The trouble's part, such as <see cref="CellTrouble.OfMachine"/>.</param>
/// <param name="name">What people call the machine or gauge.</param>
/// <param name="ask">Asks it; null if it answers.</param>
/// <param name="isTold">Whether those who work with it tell the same already.</param>
internal sealed class AnswerWatch(
    CellFlow flow, string where, string name, Func<CancellationToken, Task<AnswerProblem?>> ask,
    Func<AnswerProblem, CellTrouble, bool> isTold)
{
    private string? _code;

    /// <summary>Asks once.</summary>
    /// <returns>How long to wait before asking again.</returns>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        var problem = await ask(stop);
        if (problem?.Code != _code)
        {
            flow.Store.Audit(
                CellFlow.ByCell, problem is null ? CellCodes.AnswersAgain : CellCodes.NoAnswer, problem?.Message ?? Recorded.AnswersAgain.With(name), name);
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
            flow.Log.Warning("{Where}: {Code}: {Message}", where, problem.Code, problem.Message);
        }

        return problem?.IsOfLogin == true ? flow.Pace.Held : flow.Pace.Answer;
    }

    /// <summary>The watch of a machine: signs in, and lists its folder.</summary>
    public static AnswerWatch OfMachine(CellFlow flow, MachineSettings machine, IMachineFolder folder) => new(
        flow, CellTrouble.OfMachine(machine.Name), machine.Name, c => MachineAnswer.OfAsync(machine, folder, c),
        (p, t) => t.Code == p.Code && machine.Slots.Any(s => t.Where == CellTrouble.OfSlot(machine.Name, s.Name)));

    /// <summary>The watch of a gauge's folder.</summary>
    public static AnswerWatch OfGauge(CellFlow flow, GaugeSettings gauge) => new(
        flow, CellTrouble.OfFolder(gauge.Name), gauge.Name, new GaugeAnswer(gauge, flow.Clock).OfAsync,
        (_, t) => t.Where == CellTrouble.OfGauge(gauge.Name));
}
