using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>A bore or a boss, cut by arcs of one circle. They follow by a shift of their center and a growth of their radius.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Points">At least three labels around it.</param>
/// <param name="Method">Which circle represents its points.</param>
internal sealed record CircleFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> Points,
    CircleMethod Method)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <summary>Code of the refusal of key points that span too small an angle of their circle.</summary>
    public const string AngleTooSmall = "angle-too-small";

    /// <summary>Code of the refusal of blocks that are not arcs of one circle.</summary>
    public const string NotOneCircle = "not-one-circle";

    /// <summary>Code of the refusal of a circle that would have no radius left.</summary>
    public const string RadiusVanishes = "radius-vanishes";

    /// <summary>Smallest angle, degrees, that the points must cover for least squares. Below it, the radius is more than ten times as
    /// uncertain as the mean of the points: over 90 degrees the cosine, which a shift follows, spreads about its mean by only
    /// 0.088.</summary>
    private const double LeastAngle = 90;

    /// <summary>An inscribed or circumscribed circle needs points over more than this angle, degrees.</summary>
    private const double HalfTurn = 180;

    /// <inheritdoc/>
    public override FeatureKind Kind => CircleKind.Instance;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points { get; } = Points;

    internal override IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared =>
        [(CircleKind.ComparedDiameter, points => 2 * Fit(points, 0).Circle.Radius)];

    internal override StraightElement? Element(int? flank) => null;

    internal override FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var (wanted, found) = (Fit(theoretical, 0), Fit(actual, u));
        return new(
            [
                new(CircleKind.CenterX, wanted.Circle.Center.X, found.Circle.Center.X, found.CenterStandardError.X),
                new(CircleKind.CenterY, wanted.Circle.Center.Y, found.Circle.Center.Y, found.CenterStandardError.Y),
                new(CircleKind.Diameter, 2 * wanted.Circle.Radius, 2 * found.Circle.Radius, 2 * found.RadiusStandardError),
                new(CircleKind.Roundness, wanted.RoundnessMm, found.RoundnessMm, Math.Sqrt(2) * u),
            ],
            found.Residuals,
            []);
    }

    internal override Refusal? RefuseMap(NcPath path, FeatureMap map)
    {
        foreach (var pass in map.Passes)
        {
            var motion = FeaturePass.Moving(path, pass.First, pass.Last)
                .FirstOrDefault(i => !path.Motions[i].IsArc || !CircleKind.BelongsTo(path, pass.First, i), -1);
            if (motion >= 0)
            {
                const string Why =
                    "it is no arc of the circle that the other blocks cut. Name the arcs of the circle alone, without the way in and out.";
                return FeatureRefusal.At(path, path.Motions[motion].Block, NotOneCircle, Why, Name);
            }
        }

        var covered = 360 - ExtremeCircle.LargestGap(Point2.Origin, [.. map.Normals.Select(n => Point2.Origin + n)]).Degrees;
        var (isEnough, needed) = Method == CircleMethod.LeastSquares
            ? (covered >= LeastAngle - 1e-9, "at least 90")
            : (covered > HalfTurn, "more than 180");
        return isEnough ? null : FeatureRefusal.At(
            path,
            path.Motions[map.Passes[0].First].Block,
            AngleTooSmall,
            string.Create(
                CultureInfo.InvariantCulture,
                $"its key points cover {covered:0} degrees of the circle; expected {needed}. Measure points further round."),
            Name);
    }

    internal override Refusal? RefuseCut(FeatureCut cut)
    {
        var path = CutCircle.Of(cut);
        var wanted = Fit(path.Moved(cut.Corrections), 0).Circle;
        var growth = wanted.Radius - path.Boundary.Radius;
        var shift = wanted.Center.DistanceTo(path.Boundary.Center);
        return Math.Min(path.Path.Radius, path.Boundary.Radius) + growth > shift ? null : FeatureRefusal.At(
            cut.Path,
            cut.Path.Motions[cut.Pass.First].Block,
            RadiusVanishes,
            string.Create(
                CultureInfo.InvariantCulture,
                $"its radius would change by {growth:+0.000;-0.000} mm to {path.Path.Radius + growth:0.000} mm, and no circle about its "
                    + $"center would be left. The tool is too large for this circle, or the points are wrong."),
            Name);
    }

    internal override IEnumerable<ElementWish> Wishes(FeatureCut cut)
    {
        var path = CutCircle.Of(cut);
        return path.Wishes(cut, Fit(path.Moved(cut.Corrections), 0).Circle);
    }

    internal override IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured)
    {
        var (wanted, found) = (Fit(measured.Theoretical, 0).Circle, Fit(measured.Actual, 0).Circle);
        var boundary = Outlines.Boundary(measured.Counterpart, measured.Path, measured.Map.Passes[0]);
        return [.. boundary.Select(p => found.Foot(found.Center + (p - wanted.Center)))];
    }

    private MeasuredCircle Fit(IReadOnlyList<Point2> points, double u) =>
        FeatureFits.Named(Name, () => MeasuredCircle.Fit(Method, points, u));
}

/// <summary>The circle that represents points, by the method of the job.</summary>
/// <param name="Circle">The circle.</param>
/// <param name="CenterStandardError">Standard errors of its center in x and in y, mm.</param>
/// <param name="RadiusStandardError">Standard error of its radius, mm.</param>
/// <param name="Residuals">Signed distance of each point from it, positive outside, mm.</param>
internal sealed record MeasuredCircle(
    Circle2 Circle, Vector2 CenterStandardError, double RadiusStandardError, IReadOnlyList<double> Residuals)
{
    /// <summary>Difference between the largest and smallest distance of the points from the center, mm.</summary>
    public double RoundnessMm => Residuals.Max() - Residuals.Min();

    /// <summary>Fits it.</summary>
    /// <param name="method">The method.</param>
    /// <param name="points">The points.</param>
    /// <param name="u">Standard uncertainty of a point, mm.</param>
    /// <exception cref="GeometryException">The points determine no circle.</exception>
    public static MeasuredCircle Fit(CircleMethod method, IReadOnlyList<Point2> points, double u)
    {
        if (method == CircleMethod.LeastSquares)
        {
            var fit = CircleFit.Fit(points, u);
            return new(fit.Circle, fit.CenterStandardError, fit.RadiusStandardError, fit.Residuals);
        }

        var extreme = method == CircleMethod.Inscribed ? ExtremeCircle.Inscribed(points, u) : ExtremeCircle.Circumscribed(points, u);
        return new(extreme.Circle, extreme.CenterStandardError, extreme.RadiusStandardError, extreme.Residuals);
    }
}

/// <summary>Which circle represents measured points.</summary>
internal enum CircleMethod
{
    /// <summary>The circle with the least sum of squared distances from them (Gauss).</summary>
    LeastSquares,

    /// <summary>The largest circle with no point inside: what fits into a bore.</summary>
    Inscribed,

    /// <summary>The smallest circle with no point outside: what a boss fits into.</summary>
    Circumscribed,
}
