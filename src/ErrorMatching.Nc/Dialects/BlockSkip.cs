namespace ErrorMatching.Nc;

/// <summary>State of the machine's block skip switches, the same for all levels: whether blocks after a slash are skipped.</summary>
public enum BlockSkip : byte
{
    /// <summary>Not stated: a program that depends on it is refused.</summary>
    Unstated,

    /// <summary>Blocks after a slash are executed.</summary>
    Off,

    /// <summary>Blocks after a slash are skipped.</summary>
    On,
}

/// <summary>The words for the states of block skip in jobs, options and documents.</summary>
public static class BlockSkips
{
    /// <summary>The words that state it.</summary>
    public static IReadOnlyList<string> Words { get; } = ["off", "on"];

    /// <summary>The state for a word; unstated for any other text and for null.</summary>
    /// <param name="word">One of <see cref="Words"/>.</param>
    public static BlockSkip Of(string? word) => word switch { "off" => BlockSkip.Off, "on" => BlockSkip.On, _ => BlockSkip.Unstated };

    /// <summary>The word for a state; null if it is unstated.</summary>
    /// <param name="blockSkip">The state.</param>
    public static string? WordOf(BlockSkip blockSkip) => blockSkip switch { BlockSkip.Off => "off", BlockSkip.On => "on", _ => null };
}
