namespace ErrorMatching.Nc;

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
