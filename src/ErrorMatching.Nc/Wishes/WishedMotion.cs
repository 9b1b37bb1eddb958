using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>A motion as named in a wish.</summary>
/// <param name="Block">The N word of its block; empty if it has none.</param>
/// <param name="Line">The line of its block, from 1.</param>
/// <param name="Motion">Its position in the path.</param>
/// <param name="Source">Its place in the document; null for a wish that was not read.</param>
internal readonly record struct WishedMotion(string Block, int Line, int Motion, JsonItem? Source);
