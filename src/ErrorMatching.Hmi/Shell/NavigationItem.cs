namespace ErrorMatching.Hmi;

/// <summary>A screen in the navigation, with its name in the language of the screen.</summary>
public sealed class NavigationItem : Observable
{
    /// <summary>The item of a screen.</summary>
    public NavigationItem(Screen screen)
    {
        Screen = screen ?? throw new ArgumentNullException(nameof(screen));
    }

    /// <summary>The screen.</summary>
    public Screen Screen { get; }

    /// <summary>Its name.</summary>
    public string Name => Texts.Current["Screen." + Screen.Key];

    /// <summary>Says the name anew, in another language.</summary>
    internal void Rename() => Say(nameof(Name));
}
