namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// A piece of a contour in the generator's own frame: the material is left of the travel.
/// It knows both the path to be programmed and the boundary, which lies left of it by the offset (the tool's radius,
/// or nothing under G41 and G42).
/// </summary>
internal interface IPathElement
{
    Flat Start { get; }

    Flat End { get; }

    /// <summary>Heading of the path at its ends, radians.</summary>
    double HeadingIn { get; }

    double HeadingOut { get; }

    /// <summary>Length of the boundary, mm.</summary>
    double BoundaryLength { get; }

    /// <summary>Place on the boundary and unit normal there (from material to tool), at a length along the boundary.</summary>
    (Flat Place, Flat Normal) BoundaryAt(double length);

    IEnumerable<PathMove> Moves();

    /// <summary>Draws a deviation along the normal that a feature on this element can represent exactly,
    /// as a function of the length along the boundary.</summary>
    Func<double, double> DrawDeviation(Random random);
}
