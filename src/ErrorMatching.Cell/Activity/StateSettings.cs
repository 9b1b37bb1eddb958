namespace ErrorMatching.Cell;

/// <summary>How a machine is asked what it is doing. Each kind has a folder next to this file: its settings, and how it asks.</summary>
/// <remarks>A new kind derives from this, is registered in <see cref="StateKinds"/>, and gets its members in
/// <c>cell.schema.json</c>.</remarks>
public abstract record StateSettings
{
    // Only the configuration's own kinds can derive from this.
    private protected StateSettings()
    {
    }

    /// <summary>What is asked, for display: a path or an address.</summary>
    public abstract string Address { get; }

    /// <summary>The file that is read on this computer or a share of it; null if it is a server.</summary>
    public virtual string? LocalFile => null;

    /// <summary>The longest that one answer may take.</summary>
    public TimeSpan Timeout { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>How long a program may wait for the machine before that is a trouble. It goes on waiting.</summary>
    public TimeSpan WaitLimit { get; init; } = TimeSpan.FromHours(8);

    /// <summary>True if a program is replaced only while the machine is idle, not while it runs another program.</summary>
    public bool OnlyIdle { get; init; }

    /// <summary>Opens the source. It connects only when asked.</summary>
    /// <param name="clock">The clock, for the age of answers.</param>
    internal abstract MachineStateSource Open(TimeProvider clock);
}
