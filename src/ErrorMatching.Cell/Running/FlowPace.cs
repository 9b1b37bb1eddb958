namespace ErrorMatching.Cell;

/// <summary>The waiting times of the flow. A signal ends every wait for work early.</summary>
internal sealed record FlowPace
{
    /// <summary>How often to look for work without a signal.</summary>
    public TimeSpan Idle { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How often to look for work without a signal while the store reports every change.</summary>
    public TimeSpan Told { get; init; } = TimeSpan.FromMinutes(1);

    /// <summary>How often to check whether another process changed the store.</summary>
    public TimeSpan Store { get; init; } = TimeSpan.FromMilliseconds(200);

    /// <summary>How often to look for a machine's ready file.</summary>
    public TimeSpan Ready { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How often to ask a machine what it is doing, for people to see.</summary>
    public TimeSpan State { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>How often to ask a machine that a program waits for.</summary>
    public TimeSpan Busy { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How often to check whether machines and gauges respond.</summary>
    public TimeSpan Answer { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>How often to read the program of a taken slot again. Programs may be long, and controls slow.</summary>
    public TimeSpan Held { get; init; } = TimeSpan.FromMinutes(5);

    /// <summary>How often to check a slot that another cell is sending to.</summary>
    public TimeSpan Locked { get; init; } = TimeSpan.FromMilliseconds(200);

    /// <summary>Delay before the second attempt of a transfer; doubles with each further one.</summary>
    public TimeSpan Retry { get; init; } = TimeSpan.FromMilliseconds(500);

    /// <summary>The first pause after a full series of attempts; doubles up to <see cref="LongestPause"/>.</summary>
    public TimeSpan Pause { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>The longest pause.</summary>
    public TimeSpan LongestPause { get; init; } = TimeSpan.FromMinutes(1);

    /// <summary>How long work may continue after the cell is told to stop.</summary>
    public TimeSpan Finish { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How long recovery of a slot may take after that.</summary>
    public TimeSpan GiveBack { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>How long to wait in the end for operations that ignore cancellation, such as those on a share that hangs.</summary>
    public TimeSpan Deaf { get; init; } = TimeSpan.FromSeconds(0.5);

    /// <summary>The longest that a broker may take to answer.</summary>
    public TimeSpan BrokerAnswer { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>How often to ask a broker whether it is still there.</summary>
    public TimeSpan BrokerPing { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How long after its acknowledgment a broker must still answer before a message counts as delivered.</summary>
    public TimeSpan BrokerSettle { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>Interval of the heartbeat.</summary>
    public TimeSpan Heartbeat { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>How often to count what waits at a gauge.</summary>
    public TimeSpan Backlog { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How long a backlog must grow before that is a trouble.</summary>
    public TimeSpan BacklogGrowth { get; init; } = TimeSpan.FromMinutes(1);

    /// <summary>How often at most to publish what waits, if that has changed.</summary>
    public TimeSpan BacklogNews { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>How often to publish what waits, if that has not changed.</summary>
    public TimeSpan BacklogAgain { get; init; } = TimeSpan.FromMinutes(1);

    /// <summary>How often to remember the end of the audit trail outside of the store.</summary>
    public TimeSpan Witness { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>The pause after a number of consecutive failures, counted from 0.</summary>
    public TimeSpan PauseAfter(int failures) => TimeSpan.FromTicks(Math.Min(LongestPause.Ticks, Pause.Ticks << Math.Min(failures, 10)));
}
