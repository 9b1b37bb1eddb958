namespace ErrorMatching.Hmi;

/// <summary>A gauge in the overview.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Source">Where its files come from.</param>
/// <param name="State">Its state, in a word or a sentence.</param>
/// <param name="Severity">Its severity.</param>
public sealed record GaugeTile(string Name, string Source, string State, Severity Severity)
{
    public string AutomationId => "gauge-" + Name;
}
