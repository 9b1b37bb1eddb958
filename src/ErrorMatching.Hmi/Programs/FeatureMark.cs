namespace ErrorMatching.Hmi;

/// <summary>The marking of a feature in a program: its name next to its blocks and moves, and a bar; not color alone.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Ranges">Its blocks.</param>
/// <param name="Problem">Why some of its blocks were not found; null if all were found.</param>
public sealed record FeatureMark(string Name, IReadOnlyList<BlockRange> Ranges, string? Problem);
