namespace ErrorMatching.Hmi;

/// <summary>A gauge in the overview.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Source">Where its files come from.</param>
/// <param name="State">How it is, in a word or a sentence.</param>
/// <param name="Severity">How much it asks for attention.</param>
public sealed record GaugeTile(string Name, string Source, string State, Severity Severity)
{
    /// <summary>Identifies the tile.</summary>
    public string AutomationId => "gauge-" + Name;
}
