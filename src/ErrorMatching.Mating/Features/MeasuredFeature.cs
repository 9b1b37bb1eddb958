using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A measured feature of the part, mapped onto the counterpart's program.</summary>
/// <param name="Counterpart">The counterpart.</param>
/// <param name="Path">The program, interpreted.</param>
/// <param name="Map">Its mapping onto the program.</param>
/// <param name="Theoretical">Its key points as designed, in the part's frame.</param>
/// <param name="Actual">Its key points as measured, aligned.</param>
internal sealed record MeasuredFeature(
    JobCounterpart Counterpart,
    NcPath Path,
    FeatureMap Map,
    IReadOnlyList<Point2> Theoretical,
    IReadOnlyList<Point2> Actual)
{
    /// <summary>The measured deviation at a length along the boundary of the first pass, mm; null for kinds without a course.</summary>
    public Func<double, double>? Deviation { get; init; }
}
