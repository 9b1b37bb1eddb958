namespace ErrorMatching.Hmi;

/// <summary>A machine's slot in the overview.</summary>
/// <param name="Name">Machine and slot.</param>
/// <param name="Program">The program's name at the machine.</param>
/// <param name="State">How it is, in a word.</param>
/// <param name="Detail">What it holds, and since when.</param>
/// <param name="Waiting">How many stand in line for it, and how many will when they are approved.</param>
/// <param name="Severity">How much it asks for attention.</param>
/// <param name="Correction">What to look at; null if there is nothing.</param>
public sealed record SlotTile(string Name, string Program, string State, string Detail, string Waiting, Severity Severity, long? Correction)
{
    /// <summary>True where it was cut: how well it fits is to be looked at, and not what it changes.</summary>
    public bool IsPiece { get; init; }

    /// <summary>Identifies the tile.</summary>
    public string AutomationId => "slot-" + Name;
}
