using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A feature in the drawing of a part.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Points">Its points, labels and places, mm or schematic.</param>
public sealed record PartLine(string Name, IReadOnlyList<(string Label, Point2 At)> Points);
