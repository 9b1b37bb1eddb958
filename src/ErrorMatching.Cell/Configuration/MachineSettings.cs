namespace ErrorMatching.Cell;

/// <summary>A machine and how to reach it.</summary>
public sealed record MachineSettings
{
    /// <summary>Its name.</summary>
    public required string Name { get; init; }

    /// <summary>The transport to its programs.</summary>
    public required TransportSettings Transport { get; init; }

    /// <summary>The dialect of its control. The jobs must use the same one.</summary>
    public required string Dialect { get; init; }

    /// <summary>Its slots.</summary>
    public required IReadOnlyList<SlotSettings> Slots { get; init; }

    /// <summary>The longest that one transfer may take.</summary>
    public required TimeSpan Timeout { get; init; }

    /// <summary>True if its transport signs in with a password.</summary>
    public bool NeedsPassword => Transport.NeedsPassword;

    /// <summary>How the machine is asked what it is doing; null if nothing says that.</summary>
    public StateSettings? State { get; init; }

    /// <summary>How many times in a row a transfer is attempted before the slot waits.</summary>
    public required int Attempts { get; init; }
}

/// <summary>A place at a machine that holds one program at a time.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Program">Name of the program at the machine. The programs of all slots form the whitelist: nothing else is ever
/// written.</param>
/// <param name="ReadyFile">Name of the file by which the machine reports that the piece is cut; null if an operator reports it.</param>
public sealed record SlotSettings(string Name, string Program, string? ReadyFile);
