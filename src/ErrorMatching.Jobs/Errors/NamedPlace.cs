using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>Where a file names another one.</summary>
/// <param name="File">The file that names it.</param>
/// <param name="Path">The JSON path there.</param>
/// <param name="Place">Line and column there.</param>
public sealed record NamedPlace(string File, string Path, JsonPlace Place);
