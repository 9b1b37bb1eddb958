namespace ErrorMatching.Hmi;

/// <summary>One way that the station can look. It stays the same in another language, so that what is chosen stays chosen.</summary>
/// <param name="key">What is chosen.</param>
/// <param name="name">Gives its name in the language of the screen.</param>
public sealed class LookChoice(string key, Func<string> name) : Observable
{
    /// <summary>What is chosen.</summary>
    public string Key { get; } = key;

    /// <summary>Its name.</summary>
    public string Name => name();

    /// <summary>Identifies it.</summary>
    public string AutomationId => "look-" + Key;

    /// <summary>Says that the language is another one.</summary>
    internal void Rename() => Say(nameof(Name));
}
