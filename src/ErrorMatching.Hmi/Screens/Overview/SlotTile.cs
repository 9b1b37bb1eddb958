namespace ErrorMatching.Hmi;

/// <summary>A machine's slot in the overview.</summary>
/// <param name="Name">Machine and slot.</param>
/// <param name="Program">The program's name at the machine.</param>
/// <param name="State">Its state, in a word.</param>
/// <param name="Detail">What it holds, and since when.</param>
/// <param name="Waiting">Number of queued corrections, and of those that will be queued after approval.</param>
/// <param name="Severity">Its severity.</param>
/// <param name="Correction">The correction to open; null if there is none.</param>
public sealed record SlotTile(string Name, string Program, string State, string Detail, string Waiting, Severity Severity, long? Correction)
{
    /// <summary>True if its piece was cut: a tap then opens the verification instead of the correction.</summary>
    public bool IsPiece { get; init; }

    public string AutomationId => "slot-" + Name;
}
