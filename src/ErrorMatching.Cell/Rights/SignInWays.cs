namespace ErrorMatching.Cell;

/// <summary>How people may sign in at a station besides by password. At the console, only passwords count.</summary>
[Flags]
public enum SignInWays
{
    /// <summary>By password alone.</summary>
    Password = 0,

    /// <summary>By name and PIN.</summary>
    Pin = 1,

    /// <summary>By badge alone.</summary>
    Badge = 2,

    /// <summary>By badge and PIN.</summary>
    BadgeWithPin = 4,
}
