namespace ErrorMatching.Hmi;

/// <summary>A screen of the navigation.</summary>
/// <param name="Key">Its stable key; texts <c>Screen.KEY</c>, AutomationId <c>nav-KEY</c>, icon <c>Icon.KEY</c>.</param>
/// <param name="Open">Creates its view model.</param>
public sealed record Screen(string Key, Func<ShellViewModel, ScreenViewModel> Open)
{
    /// <summary>Identifies its button for tests and screen reader scripts.</summary>
    public string AutomationId => "nav-" + Key;

    public string Icon => "Icon." + Key;
}
