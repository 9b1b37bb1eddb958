using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A free-form job of the cell.</summary>
/// <param name="Name">Its display name.</param>
/// <param name="Settings">The job.</param>
internal sealed record SurfaceJobChoice(string Name, CellJobSettings Settings);
