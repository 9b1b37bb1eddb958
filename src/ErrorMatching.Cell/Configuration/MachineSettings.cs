namespace ErrorMatching.Cell;

/// <summary>A machine and the way to it.</summary>
public sealed record MachineSettings
{
    /// <summary>What people call it.</summary>
    public required string Name { get; init; }

    /// <summary>How its programs are reached.</summary>
    public required TransportSettings Transport { get; init; }

    /// <summary>Dialect of its control, which the jobs must have too.</summary>
    public required string Dialect { get; init; }

    /// <summary>Its slots.</summary>
    public required IReadOnlyList<SlotSettings> Slots { get; init; }

    /// <summary>How long one transfer may take.</summary>
    public required TimeSpan Timeout { get; init; }

    /// <summary>True if its transport signs in by a password.</summary>
    public bool NeedsPassword => Transport.NeedsPassword;

    /// <summary>How often a transfer is tried in a row before the slot waits a while.</summary>
    public required int Attempts { get; init; }
}
