using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point of the part and of two counterparts, in the part's frame.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Part">As measured on the part.</param>
/// <param name="Before">As measured on the counterpart that was cut without compensation.</param>
/// <param name="After">As measured on the counterpart that was cut with it.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool.</param>
public sealed record VerifiedPoint(string Label, Point2 Part, Point2 Before, Point2 After, Vector2 Normal)
{
    /// <summary>The mating error before: counterpart - part.</summary>
    public MatingError BeforeError => new(Before - Part, Normal);

    /// <summary>The mating error after: counterpart - part.</summary>
    public MatingError AfterError => new(After - Part, Normal);
}
