namespace ErrorMatching.Hmi;

/// <summary>A user's preferences.</summary>
/// <param name="Language">The language.</param>
/// <param name="IsDark">True for the dark theme.</param>
/// <param name="TouchSize">Height of touch targets.</param>
/// <param name="Keyboard">When the keyboard on the screen opens.</param>
/// <param name="Folders">Recently used folders, latest first.</param>
public sealed record Preferences(
    Language Language, bool IsDark, TouchSize TouchSize, KeyboardUse Keyboard, IReadOnlyList<string> Folders)
{
    /// <summary>When the keyboard on the screen opens if nobody has chosen: Windows opens its own.</summary>
    public static KeyboardUse UsualKeyboard => OperatingSystem.IsWindows() ? KeyboardUse.Never : KeyboardUse.Finger;
}

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

/// <summary>When the keyboard on the screen opens.</summary>
public enum KeyboardUse
{
    /// <summary>When a finger or a pen leads to a field.</summary>
    Finger,

    /// <summary>When a mouse does, too.</summary>
    Always,

    /// <summary>Never.</summary>
    Never,
}
