using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;
using MathNet.Numerics.Integration;

namespace ErrorMatching.Mating;

/// <summary>A hill or a valley.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Points">At least three labels in the order of cutting.</param>
/// <param name="Degree">Degree of the polynomial; null to choose it by leave-one-out error.</param>
/// <param name="Ridge">Weight against overfitting; null to choose it by leave-one-out error.</param>
internal sealed record CurveFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> Points,
    int? Degree,
    double? Ridge)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <summary>Recommended spacing of key points along a curve (Wang 2021, section 2.1).</summary>
    private const double RecommendedSpacingMm = 5;

    // 64 nodes integrate the arc length of a polynomial of degree 10 to nanometers if its slope is below 10.
    private const int QuadratureOrder = 64;

    /// <summary>Centers and radii that differ by no more are those of one circle, mm.</summary>
    private const double SameCircleMm = 0.01;

    /// <inheritdoc/>
    public override FeatureKind Kind => CurveKind.Instance;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points { get; } = Points;

    internal override IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared => [];

    internal override StraightElement? Element(int? flank) => null;

    internal override FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var options = new PolynomialFitOptions { Degree = Degree, Ridge = Ridge, PointUncertaintyMm = u };
        var chord = new FeatureQuantity(
            CurveKind.Chord, theoretical[0].DistanceTo(theoretical[^1]), actual[0].DistanceTo(actual[^1]), Math.Sqrt(2) * u);
        var (wanted, found) = (Fit(theoretical, options), Fit(actual, options));
        if (wanted is null || found is null)
        {
            return new([chord], [], [.. Sparse(Polyline(theoretical)), WarningForms.Warning(WarningForms.FoldedCurve, Name)]);
        }

        var length = ArcLength(wanted);
        return new([chord, new(CurveKind.ArcLength, length, ArcLength(found), Math.Sqrt(2) * u)], found.Residuals, Sparse(length))
        {
            Curve = found
        };
    }

    // An arc of the program can only follow as an arc.
    internal override IEnumerable<BoundaryElement> Elements(NcPath path, FeaturePass pass) =>
        [
            SweepOf(path, pass) is { } sweep
                ? new(pass, pass.First, pass.Last, ElementForm.Arc) { Sweep = sweep }
                : new(pass, pass.First, pass.Last, ElementForm.Free) { Degree = Degree, Ridge = Ridge ?? 0 }];

    internal override IEnumerable<ElementWish> Wishes(FeatureCut cut) => FeatureWish.Along(cut);

    internal override IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured) =>
        Outlines.Boundary(measured.Counterpart, measured.Path, measured.Map.Passes[0], measured.Deviation!);

    // The angle that a pass turns, radians, if it consists of arcs of one circle; otherwise null.
    private static double? SweepOf(NcPath path, FeaturePass pass)
    {
        var (first, sweep) = (path.Motions[pass.First], 0.0);
        foreach (var i in FeaturePass.Moving(path, pass.First, pass.Last))
        {
            var motion = path.Motions[i];
            if (motion.Kind != first.Kind
                || !motion.IsArc
                || motion.Center.DistanceTo(first.Center) > SameCircleMm
                || Math.Abs(motion.Arc.Radius - first.Arc.Radius) > SameCircleMm)
            {
                return null;
            }

            sweep += Math.Abs(motion.Arc.Sweep.Radians);
        }

        return sweep;
    }

    /// <summary>The fit; null for a curve that is not a function over its chord. Its compensation works along the boundary and needs no
    /// fit.</summary>
    private CurveFit? Fit(IReadOnlyList<Point2> points, PolynomialFitOptions options)
    {
        try
        {
            return FeatureFits.Named(Name, () => CurveFit.Fit(points, options));
        }
        catch (GeometryException e) when (e.Error == GeometryError.FoldedCurve)
        {
            return null;
        }
    }

    /// <summary>Length of the fitted curve: the integral of sqrt(1 + f'^2) over its chord by Gauss-Legendre quadrature.</summary>
    private static double ArcLength(CurveFit curve) => GaussLegendreRule.Integrate(
        along => Math.Sqrt(1 + Elementary.Pow(curve.Polynomial.Derivative(along), 2)), 0, curve.Chord.Length, QuadratureOrder);

    private static double Polyline(IReadOnlyList<Point2> points) => points.Zip(points.Skip(1), (a, b) => a.DistanceTo(b)).Sum();

    private List<ReportWarning> Sparse(double lengthMm)
    {
        if (Points.Count >= lengthMm / RecommendedSpacingMm)
        {
            return [];
        }

        var (count, length, spacing) = (
            Points.Count.ToString(CultureInfo.InvariantCulture),
            lengthMm.ToString("0.#", CultureInfo.InvariantCulture),
            RecommendedSpacingMm.ToString(CultureInfo.InvariantCulture));
        return [WarningForms.Warning(WarningForms.SparsePoints, Name, count, length, spacing)];
    }
}
