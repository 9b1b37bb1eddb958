using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A boundary whose blocks are sought in a program.</summary>
/// <param name="Name">Name of its feature, for messages.</param>
/// <param name="Plane">The plane that it lies in.</param>
/// <param name="Points">Its key points in the order of cutting or against it: their labels, and where they lie in the program, mm.</param>
public sealed record SoughtBoundary(string Name, CoordinatePlane Plane, IReadOnlyList<(string Label, Point2 At)> Points)
{
    /// <summary>Its kind; null if it is not known.</summary>
    public FeatureKind? Kind { get; init; }

    /// <summary>True if it is straight at both ends, as a line and the flanks of a triangle are: no arc and no bend continues it.</summary>
    public bool IsStraight => Kind?.IsStraight == true;
}
