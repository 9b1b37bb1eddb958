using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>Where one file names another.</summary>
/// <param name="File">The file that names the other.</param>
/// <param name="Path">The JSON path in it.</param>
/// <param name="Place">Line and column in it.</param>
public sealed record NamedPlace(string File, string Path, JsonPlace Place);
