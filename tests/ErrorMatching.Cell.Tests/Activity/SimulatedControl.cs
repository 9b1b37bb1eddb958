namespace ErrorMatching.Cell.Tests;

/// <summary>A control whose state changes at random whenever somebody asks it or does something with its files, except between an answer
/// and the replacement that follows it at once: that window no cell can close.</summary>
/// <param name="seed">Of the random states.</param>
/// <param name="program">The program that a cell sends.</param>
/// <param name="freed">How likely a change frees the program.</param>
internal sealed class SimulatedControl(int seed, string program, double freed = 0.03)
{
    private const double Seized = 0.2;
    private readonly Random _random = new(seed);
    private readonly Lock _gate = new();
    private bool _isUsed = true;

    /// <summary>The state of the moment.</summary>
    public MachineState State { get; private set; } = ToldState.Of(MachineActivity.Running, program);

    /// <summary>How often the state changed.</summary>
    public int Changes { get; private set; }

    /// <summary>Replacements of the program.</summary>
    public int Replaced { get; private set; }

    /// <summary>States in which the program was replaced although it was in use.</summary>
    public List<MachineState> Wrong { get; } = [];

    /// <summary>The answer to a question, after a change.</summary>
    public MachineState Ask()
    {
        lock (_gate)
        {
            Change();
            return State;
        }
    }

    /// <summary>Something is done at the machine.</summary>
    /// <param name="isReplacing">True if it takes the program's name away from it.</param>
    public void Do(bool isReplacing)
    {
        lock (_gate)
        {
            if (!isReplacing)
            {
                Change();
                return;
            }

            Replaced++;
            if (_isUsed)
                Wrong.Add(State);
        }
    }

    private void Change()
    {
        Changes++;
        var draw = _random.NextDouble();
        _isUsed = _isUsed ? draw >= freed : draw < Seized;
        if (!_isUsed)
        {
            State = _random.Next(2) == 0 ? ToldState.Of(MachineActivity.Idle, program) : ToldState.Of(MachineActivity.Running, "O9.NC");
            return;
        }

        State = _random.Next(6) switch
        {
            0 => ToldState.Of(MachineActivity.Held, "/nc/" + program),
            1 => ToldState.Of(MachineActivity.Alarm, program),
            2 => MachineState.Unknown("it does not say", StateCodes.Away),
            3 => new(MachineActivity.Running, null, null),
            _ => ToldState.Of(MachineActivity.Running, program),
        };
    }
}
