using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A key point in a drawing of the assembly.</summary>
/// <param name="Label">Its label.</param>
/// <param name="At">Its place on the drawn boundary, mm.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool: into the part.</param>
/// <param name="Part">Distance of the part from there along the normal, mm.</param>
/// <param name="Before">Distance of the counterpart without compensation, mm.</param>
/// <param name="After">Distance of the counterpart with compensation, mm.</param>
internal sealed record DrawnPoint(string Label, Point2 At, Vector2 Normal, double Part, double Before, double After)
{
    /// <summary>Half the 95 % interval about both mating errors, mm; null if it is not known.</summary>
    public double? Interval95Mm { get; init; }

    /// <summary>The mating error of a counterpart in words.</summary>
    /// <param name="counterpart">Distance of that counterpart along the normal, mm.</param>
    public string ErrorWords(double counterpart) => Interval95Mm is { } half
        ? ReportNumber.Interval(counterpart - Part, half) + " mm"
        : ReportNumber.SignedMm(counterpart - Part);
}
