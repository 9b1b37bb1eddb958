namespace ErrorMatching.Hmi;

/// <summary>How a person likes the station.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for light on dark.</param>
/// <param name="TouchSize">How high what is touched is.</param>
/// <param name="Folders">Folders in which something was chosen, the latest first.</param>
public sealed record Preferences(Language Language, bool IsDark, TouchSize TouchSize, IReadOnlyList<string> Folders);
