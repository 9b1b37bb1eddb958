using System.Text.Json.Serialization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>What a machine was doing when the running cell asked it last.</summary>
/// <param name="Machine">Its name.</param>
/// <param name="State">What it said. Its time is that of the cell's first answer of this kind, if the machine names none.</param>
public sealed record MachineReport(string Machine, MachineState State)
{
    /// <summary>Why the state is unknown, as it is recorded; null if it is known.</summary>
    public string? Why { get; init; }

    /// <summary>Why the state is unknown; null if it is known.</summary>
    [JsonIgnore]
    public Statement? Reason => Why is { } text ? Recorded.Read(text) : null;
}

/// <summary>An approved program that is not sent yet, because its machine must not be disturbed.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">The slot.</param>
/// <param name="Correction">Number of the correction.</param>
/// <param name="Why">The reason as it is recorded.</param>
/// <param name="Since">Since when it waits.</param>
public sealed record WaitingDelivery(string Machine, string Slot, long Correction, string Why, DateTimeOffset Since)
{
    /// <summary>The reason as a statement.</summary>
    [JsonIgnore]
    public Statement Statement => Recorded.Read(Why);
}
