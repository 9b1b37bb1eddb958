namespace ErrorMatching.Hmi;

/// <summary>Appearance of the station at its start.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for the dark theme.</param>
/// <param name="IsFullScreen">True for full screen.</param>
public sealed record StationLook(Language Language, bool IsDark, bool IsFullScreen);
