namespace ErrorMatching.Hmi;

/// <summary>How urgently something needs attention. Each level has a color, an icon and a word: never color alone.</summary>
public enum Severity
{
    /// <summary>Normal.</summary>
    Quiet,

    /// <summary>Needs a person's decision.</summary>
    Attention,

    /// <summary>Something cannot work.</summary>
    Alarm,
}
