using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A notch or a ridge of two straight flanks.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="FirstFlank">At least two labels on the flank that is cut first, in the order of cutting.</param>
/// <param name="SecondFlank">At least two labels on the other flank, in the order of cutting.</param>
internal sealed record TriangleFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> FirstFlank,
    IReadOnlyList<string> SecondFlank)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <inheritdoc/>
    public override FeatureKind Kind => TriangleKind.Instance;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points => [.. FirstFlank, .. SecondFlank];

    /// <inheritdoc/>
    public override IReadOnlyList<IReadOnlyList<string>> PointLists => [FirstFlank, SecondFlank];

    internal override IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared =>
        [(VerifiedQuantity.Angle, points => Fit(points, 0).IncludedAngle.Degrees)];

    internal override StraightElement? Element(int? flank) =>
        flank is 1 or 2 ? new(flank == 1 ? FirstFlank : SecondFlank, LineMethod.Total) : null;

    internal override FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var (wanted, found) = (Fit(theoretical, 0), Fit(actual, u));

        // A flank runs from the apex to a measured point. Along it, the apex is off by at most its whole standard error.
        var flank = new Vector2(found.ApexStandardError.Length, u).Length;
        return new(
            [
                new(TriangleKind.ApexX, wanted.Apex.X, found.Apex.X, found.ApexStandardError.X),
                new(TriangleKind.ApexY, wanted.Apex.Y, found.Apex.Y, found.ApexStandardError.Y),
                new(
                    TriangleKind.IncludedAngle,
                    wanted.IncludedAngle.Degrees,
                    found.IncludedAngle.Degrees,
                    found.IncludedAngleStandardError.Degrees),
                new(TriangleKind.FirstFlank, wanted.FirstLength, found.FirstLength, flank),
                new(TriangleKind.SecondFlank, wanted.SecondLength, found.SecondLength, flank),
            ],
            [.. found.First.Residuals, .. found.Second.Residuals],
            []);
    }

    internal override IEnumerable<BoundaryElement> Elements(NcPath path, FeaturePass pass) =>
        TriangleWish.Flanks(path, pass, FirstFlank.Count);

    internal override IEnumerable<ElementWish> Wishes(FeatureCut cut) => TriangleWish.For(cut);

    internal override IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured) =>
        [measured.Actual[0], Fit(measured.Actual, 0).Apex, measured.Actual[^1]];

    private Wedge Fit(IReadOnlyList<Point2> points, double u) =>
        FeatureFits.Wedge(Name, [.. points.Take(FirstFlank.Count)], [.. points.Skip(FirstFlank.Count)], u);
}
