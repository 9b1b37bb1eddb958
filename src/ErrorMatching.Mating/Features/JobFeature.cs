using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>A feature of the mating boundary: its key points, its limits, and the blocks that cut it. Subclasses add what is specific to
/// a kind.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Block selectors as in the job: <c>N100</c>, <c>N110..N130</c> or <c>/regular expression/</c>.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
public abstract record JobFeature(string Name, IReadOnlyList<string> Blocks, JobTolerance Tolerance, CoordinatePlane Plane)
{
    /// <summary>The gap that is wanted between the pieces, along the normal, mm; negative for a press fit.</summary>
    public double GapMm { get; init; }

    /// <summary>True if what the counterpart's program does differently from the theoretical outline is corrected, too; otherwise it stays,
    /// and counts.</summary>
    public bool CorrectsBase { get; init; }

    /// <summary>Standard deviation of the form error that its points do not tell, such as the bow of a line with two points, mm; null if
    /// nothing is stated.</summary>
    public double? FormMm { get; init; }

    /// <summary>Its kind.</summary>
    public abstract FeatureKind Kind { get; }

    /// <summary>The labels of all its key points in the order of cutting, ranges expanded.</summary>
    public abstract IReadOnlyList<string> Points { get; }

    /// <summary>The labels list by list, as a job writes them (<see cref="FeatureKind.LeastPoints"/>).</summary>
    public virtual IReadOnlyList<IReadOnlyList<string>> PointLists => [Points];

    /// <summary>Quantities that a verification compares, and how to compute them from its points in the order of
    /// <see cref="Points"/>.</summary>
    internal abstract IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared { get; }

    /// <summary>A straight element of it.</summary>
    /// <param name="flank">1 or 2 for a flank in the order of cutting; null for the whole feature.</param>
    /// <returns>The element; null if it does not exist.</returns>
    internal abstract StraightElement? Element(int? flank);

    /// <summary>Its size and shape as designed and as measured.</summary>
    /// <param name="theoretical">Its theoretical points in its plane, in the order of <see cref="Points"/>.</param>
    /// <param name="actual">Its measured points, aligned, in the same order.</param>
    /// <param name="u">Standard uncertainty of a measured coordinate, mm.</param>
    /// <exception cref="GeometryException">The points do not determine it; the message names it.</exception>
    internal abstract FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u);

    /// <summary>Why its points or its blocks do not fit a feature of its kind, or null.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="map">Its mapping onto the program.</param>
    internal virtual Refusal? RefuseMap(NcPath path, FeatureMap map) => null;

    /// <summary>The elements of one of its cuts that deviate on their own, in the order of cutting; none for kinds that are estimated as a
    /// whole from their own points.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="pass">The cut.</param>
    internal virtual IEnumerable<BoundaryElement> Elements(NcPath path, FeaturePass pass) => [];

    /// <summary>Why a cut cannot follow the corrections at its points, or null.</summary>
    /// <param name="cut">One of its cuts.</param>
    internal virtual Refusal? RefuseCut(FeatureCut cut) => null;

    /// <summary>The wishes for one of its cuts, in the order of its motions.</summary>
    /// <param name="cut">A cut that <see cref="RefuseCut"/> accepts.</param>
    internal abstract IEnumerable<ElementWish> Wishes(FeatureCut cut);

    /// <summary>The measured boundary that the compensation uses, as a polyline in the part's frame.</summary>
    internal abstract IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured);
}
