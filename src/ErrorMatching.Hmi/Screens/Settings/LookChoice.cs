namespace ErrorMatching.Hmi;

/// <summary>An option for the appearance. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="key">Its key.</param>
/// <param name="name">Returns its name in the display language.</param>
internal sealed class LookChoice(string key, Func<string> name) : Observable
{
    public string Key { get; } = key;

    public string Name => name();

    public string AutomationId => "look-" + Key;

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
