namespace ErrorMatching.Hmi;

/// <summary>A correction that waits for a person, or is on its way, in the overview.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Title">Job and serial number.</param>
/// <param name="State">What it waits for.</param>
/// <param name="Largest">Its largest displacement in mm.</param>
/// <param name="Since">Since when.</param>
/// <param name="Severity">How much it asks for attention.</param>
public sealed record WaitingTile(long Id, string Title, string State, string Largest, string Since, Severity Severity)
{
    /// <summary>Identifies the tile.</summary>
    public string AutomationId => "waiting-" + Shown.Id(Id);
}
