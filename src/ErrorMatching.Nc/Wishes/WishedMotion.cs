using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>A motion as a wish names it.</summary>
/// <param name="Block">The N word of its block, or an empty text.</param>
/// <param name="Line">The line of its block, from 1.</param>
/// <param name="Motion">Its position in the path.</param>
/// <param name="Source">Where the document says so; null for a wish that was not read.</param>
internal readonly record struct WishedMotion(string Block, int Line, int Motion, JsonItem? Source);
