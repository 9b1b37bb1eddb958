namespace ErrorMatching.Hmi;

/// <summary>How a station begins.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for light on dark.</param>
/// <param name="IsFullScreen">True if it fills the screen.</param>
public sealed record StationLook(Language Language, bool IsDark, bool IsFullScreen);
