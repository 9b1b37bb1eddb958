namespace ErrorMatching.Hmi;

/// <summary>How much something asks for attention. Each has a color, an icon and a word: never the color alone.</summary>
public enum Severity
{
    /// <summary>The ordinary course.</summary>
    Quiet,

    /// <summary>Waits for a person.</summary>
    Attention,

    /// <summary>Keeps something from working.</summary>
    Alarm,
}
