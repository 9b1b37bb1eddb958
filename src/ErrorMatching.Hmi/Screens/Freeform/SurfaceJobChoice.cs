using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A free-form job of the cell.</summary>
/// <param name="Name">What people call it.</param>
/// <param name="Settings">The job.</param>
public sealed record SurfaceJobChoice(string Name, CellJobSettings Settings);
