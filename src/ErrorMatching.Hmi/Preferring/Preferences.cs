namespace ErrorMatching.Hmi;

/// <summary>A user's preferences.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for the dark theme.</param>
/// <param name="TouchSize">Height of touch targets.</param>
/// <param name="Folders">Recently used folders, latest first.</param>
public sealed record Preferences(Language Language, bool IsDark, TouchSize TouchSize, IReadOnlyList<string> Folders);

/// <summary>Height of touch targets.</summary>
public enum TouchSize
{
    /// <summary>15 mm.</summary>
    Standard,

    /// <summary>17.5 mm, for thick gloves.</summary>
    Large,

    /// <summary>20 mm.</summary>
    Largest,
}
