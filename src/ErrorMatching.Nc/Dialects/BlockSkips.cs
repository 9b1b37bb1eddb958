namespace ErrorMatching.Nc;

/// <summary>The positions of block skip as words of jobs, options and documents.</summary>
public static class BlockSkips
{
    /// <summary>The words that state a position.</summary>
    public static IReadOnlyList<string> Words { get; } = ["off", "on"];

    /// <summary>The position that a word states; unstated for any other text and for none.</summary>
    /// <param name="word">One of <see cref="Words"/>.</param>
    public static BlockSkip Of(string? word) => word switch { "off" => BlockSkip.Off, "on" => BlockSkip.On, _ => BlockSkip.Unstated };

    /// <summary>The word of a position; null where none is stated.</summary>
    /// <param name="blockSkip">The position.</param>
    public static string? WordOf(BlockSkip blockSkip) => blockSkip switch { BlockSkip.Off => "off", BlockSkip.On => "on", _ => null };
}
