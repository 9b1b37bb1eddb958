namespace ErrorMatching.Cell;

/// <summary>How long the flow waits for what. A signal ends every wait for work early.</summary>
internal sealed record FlowPace
{
    /// <summary>How often work is looked for without a signal.</summary>
    public TimeSpan Idle { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How often the store is asked whether another process changed it.</summary>
    public TimeSpan Store { get; init; } = TimeSpan.FromMilliseconds(200);

    /// <summary>How often a machine is asked for its ready file.</summary>
    public TimeSpan Ready { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How often machines and gauges are asked whether they answer.</summary>
    public TimeSpan Answer { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>How often the program of a taken slot is read again. Programs may be long, and controls slow.</summary>
    public TimeSpan Held { get; init; } = TimeSpan.FromMinutes(5);

    /// <summary>How often a slot that another cell sends to is looked at.</summary>
    public TimeSpan Locked { get; init; } = TimeSpan.FromMilliseconds(200);

    /// <summary>Before the second try of a transfer; doubles with each further one.</summary>
    public TimeSpan Retry { get; init; } = TimeSpan.FromMilliseconds(500);

    /// <summary>The first pause after all tries in a row; doubles up to <see cref="LongestPause"/>.</summary>
    public TimeSpan Pause { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>The longest pause.</summary>
    public TimeSpan LongestPause { get; init; } = TimeSpan.FromMinutes(1);

    /// <summary>How long work may go on once the cell is told to stop.</summary>
    public TimeSpan Finish { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How long bringing a slot back into order may take after that.</summary>
    public TimeSpan GiveBack { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>How long what does not hear that it shall end is waited for at last, such as a share that hangs.</summary>
    public TimeSpan Deaf { get; init; } = TimeSpan.FromSeconds(0.5);

    /// <summary>How often the cell says that it lives.</summary>
    public TimeSpan Heartbeat { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>The pause after so many failures in a row, counted from 0.</summary>
    public TimeSpan PauseAfter(int failures) => TimeSpan.FromTicks(Math.Min(LongestPause.Ticks, Pause.Ticks << Math.Min(failures, 10)));
}
