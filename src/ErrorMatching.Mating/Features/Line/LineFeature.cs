using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A straight line.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Points">At least two labels in the order of cutting.</param>
/// <param name="Method">How the line is fitted.</param>
internal sealed record LineFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> Points,
    LineMethod Method)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <inheritdoc/>
    public override FeatureKind Kind => LineKind.Instance;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points { get; } = Points;

    internal override IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared =>
        [(VerifiedQuantity.Length, points => FeatureFits.Line(Name, Method, points, 0).Length)];

    internal override StraightElement? Element(int? flank) => flank is null ? new(Points, Method) : null;

    internal override FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var wanted = FeatureFits.Line(Name, Method, theoretical, 0);
        var found = FeatureFits.Line(Name, Method, actual, u);
        return new(
            [
                new(LineKind.Length, wanted.Length, found.Length, Math.Sqrt(2) * u),
                new(
                    FeatureQuantity.Direction,
                    wanted.Line.Direction.Direction.Normalized.Degrees,
                    found.Line.Direction.Direction.Normalized.Degrees,
                    found.AngleStandardError.Degrees),
            ],
            found.Residuals,
            []);
    }

    internal override IEnumerable<BoundaryElement> Elements(NcPath path, FeaturePass pass) =>
        [new(pass, pass.First, pass.Last, ElementForm.Straight)];

    internal override IEnumerable<ElementWish> Wishes(FeatureCut cut) => FeatureWish.Along(cut);

    internal override IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured) => measured.Actual;
}
