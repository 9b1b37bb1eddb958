using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>A boundary whose blocks are to be found in a program.</summary>
/// <param name="Name">Name of its feature, for messages.</param>
/// <param name="Plane">Its plane.</param>
/// <param name="Points">Its key points in the order of cutting or in reverse: their labels and their positions in the program,
/// mm.</param>
public sealed record SoughtBoundary(string Name, CoordinatePlane Plane, IReadOnlyList<(string Label, Point2 At)> Points)
{
    /// <summary>Its kind; null if unknown.</summary>
    public FeatureKind? Kind { get; init; }

    /// <summary>True if both ends are straight, like a line and the flanks of a triangle, so that no arc or bend continues it.</summary>
    public bool IsStraight => Kind?.IsStraight == true;
}

/// <summary>The result of a search for a boundary.</summary>
/// <param name="Passes">The passes that cut it, in the order of the program; empty if it was not found.</param>
/// <param name="Refusal">Why it was not found, or null.</param>
public sealed record FoundBoundary(IReadOnlyList<FoundPass> Passes, Refusal? Refusal = null);
