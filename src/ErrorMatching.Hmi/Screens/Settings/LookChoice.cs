namespace ErrorMatching.Hmi;

/// <summary>One way that the station can look.</summary>
/// <param name="Key">What is chosen.</param>
/// <param name="Name">Its name.</param>
public sealed record LookChoice(string Key, string Name)
{
    /// <summary>Identifies it.</summary>
    public string AutomationId => "look-" + Key;
}
