using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Appearance of the station at its start.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for the dark theme.</param>
/// <param name="IsFullScreen">True for full screen.</param>
/// <param name="IsMaximized">True for a window as large as the desktop; full screen has priority.</param>
public sealed record StationLook(Language Language, bool IsDark, bool IsFullScreen, bool IsMaximized = false)
{
    /// <summary>True for the overview alone, for a wall.</summary>
    public bool IsAndon { get; init; }

    /// <summary>The state in which the window opens.</summary>
    internal WindowState State =>
        IsFullScreen || IsAndon ? WindowState.FullScreen : IsMaximized ? WindowState.Maximized : WindowState.Normal;
}
