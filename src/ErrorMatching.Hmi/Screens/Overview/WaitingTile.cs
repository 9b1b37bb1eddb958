namespace ErrorMatching.Hmi;

/// <summary>In the overview: a correction that waits for a person or is on its way, or the newest counterpart of a workpiece that
/// was measured outside its limits.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Job">The workpiece's name; empty before it is recognized.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="State">What it waits for.</param>
/// <param name="Largest">Its largest displacement in mm.</param>
/// <param name="Since">Since when it waits.</param>
/// <param name="Severity">Its severity.</param>
public sealed record WaitingTile(long Id, string Job, string Title, string State, string Largest, string Since, Severity Severity)
{
    /// <summary>True for a measured counterpart: a tap then opens the verification instead of the correction.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if its job was changed after it was computed.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>True if its largest displacement is known.</summary>
    public bool HasLargest => Largest.Length > 0;

    /// <summary>Its name for screen readers.</summary>
    public string Name => Job.Length > 0 ? $"{Job} · {Title}" : Title;

    public string AutomationId => (IsMeasured ? "measured-" : "waiting-") + Shown.Id(Id);
}
