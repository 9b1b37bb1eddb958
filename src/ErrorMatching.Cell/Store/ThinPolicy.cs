namespace ErrorMatching.Cell;

/// <summary>Which contents are moved to an archive.</summary>
/// <param name="Before">Corrections whose last step was before this time may lose their contents.</param>
/// <param name="KeepLast">Of each slot, this many of the latest corrections keep theirs, however old they are.</param>
public sealed record ThinPolicy(DateTimeOffset Before, int KeepLast);

/// <summary>What was moved, or would be.</summary>
/// <param name="Contents">Number of contents.</param>
/// <param name="Bytes">Their length as stored.</param>
/// <param name="Archives">Names of the archives, in the order in which they were recorded; none for a rehearsal.</param>
public sealed record Thinned(long Contents, long Bytes, IReadOnlyList<string> Archives);
