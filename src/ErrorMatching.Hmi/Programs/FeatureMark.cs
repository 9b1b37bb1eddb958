namespace ErrorMatching.Hmi;

/// <summary>A feature as it is marked in a program: by its name beside its blocks and its moves, and by a bar; not by a color alone.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Ranges">Its blocks.</param>
/// <param name="Problem">Why its blocks could not all be found; null if they were.</param>
public sealed record FeatureMark(string Name, IReadOnlyList<BlockRange> Ranges, string? Problem);
