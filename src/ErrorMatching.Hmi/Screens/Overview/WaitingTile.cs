namespace ErrorMatching.Hmi;

/// <summary>A correction that waits for a person, or is on its way, or the newest counterpart of a workpiece that was measured outside of its limits, in the overview.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Job">What people call the workpiece; empty before it is recognized.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="State">What it waits for.</param>
/// <param name="Largest">Its largest displacement in mm.</param>
/// <param name="Since">Since when.</param>
/// <param name="Severity">How much it asks for attention.</param>
public sealed record WaitingTile(long Id, string Job, string Title, string State, string Largest, string Since, Severity Severity)
{
    /// <summary>True for a counterpart that was measured: how well it fits is to be looked at, and not what it changes.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if it was made with its job as it was before somebody changed that.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>True once it is known by how much it moves.</summary>
    public bool HasLargest => Largest.Length > 0;

    /// <summary>What it is called aloud.</summary>
    public string Name => Job.Length > 0 ? $"{Job} · {Title}" : Title;

    /// <summary>Identifies the tile.</summary>
    public string AutomationId => (IsMeasured ? "measured-" : "waiting-") + Shown.Id(Id);
}
