namespace ErrorMatching.Hmi;

/// <summary>A screen in the navigation, with its name in the display language.</summary>
public sealed class NavigationItem : Observable
{
    public NavigationItem(Screen screen)
    {
        Screen = screen ?? throw new ArgumentNullException(nameof(screen));
    }

    public Screen Screen { get; }

    public string Name => Texts.Current["Screen." + Screen.Key];

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
