namespace ErrorMatching.Hmi;

/// <summary>A screen that can be gone to.</summary>
/// <param name="Key">Its stable name; texts <c>Screen.KEY</c>, AutomationId <c>nav-KEY</c>, icon <c>Icon.KEY</c>.</param>
/// <param name="Open">Makes its view model.</param>
public sealed record Screen(string Key, Func<ShellViewModel, ScreenViewModel> Open)
{
    /// <summary>Identifies its button for tests and screen readers' scripts.</summary>
    public string AutomationId => "nav-" + Key;

    /// <summary>Key of its icon.</summary>
    public string Icon => "Icon." + Key;
}
