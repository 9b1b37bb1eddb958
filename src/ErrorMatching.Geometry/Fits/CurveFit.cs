using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A curve (a hill or a valley) fitted as a polynomial over its own chord, the line from its first to its last point. The height
/// to the left of the chord is a function of the position along it, in any orientation. Equations 3 and 5 of Wang 2021 use y(x), which is
/// only valid for flat curves. Immutable.</summary>
public sealed class CurveFit
{
    private CurveFit(Segment2 chord, PolynomialFit polynomial) => (Chord, Polynomial) = (chord, polynomial);

    /// <summary>The line from the first to the last measured point. Its direction is the abscissa of the fit, starting with 0 at the first
    /// point; its left is the ordinate.</summary>
    public Segment2 Chord { get; }

    /// <summary>The fit of height over position along the chord, both in millimeters.</summary>
    public PolynomialFit Polynomial { get; }

    /// <summary>Measured minus fitted height of each point, positive left of the chord, in the given order, in millimeters.</summary>
    public IReadOnlyList<double> Residuals => Polynomial.Residuals;

    /// <summary>Root of the sum of squared residuals divided by the remaining degrees of freedom, in millimeters.</summary>
    public double ResidualStandardDeviation => Polynomial.ResidualStandardDeviation;

    /// <summary>Fits a curve to points in order.</summary>
    /// <param name="points">At least three points, each farther along the chord than the previous one.</param>
    /// <param name="options">Degree, ridge and stated uncertainty; null selects the degree and does not regularize.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>;
    /// <see cref="GeometryError.CoincidentPoints"/> if the
    /// first and last point, or two neighbors, are within 1e-9 mm; <see cref="GeometryError.FoldedCurve"/> if a point is not farther along
    /// the chord than the previous one; or as for
    /// <see cref="PolynomialFit.Fit(IReadOnlyList{DoubleDouble}, IReadOnlyList{DoubleDouble}, PolynomialFitOptions?)"/>.</exception>
    public static CurveFit Fit(IReadOnlyList<Point2> points, PolynomialFitOptions? options = null)
    {
        Samples.Check(points, 3, "A curve");
        var chord = new Segment2(points[0], points[^1]);
        if (chord.Length <= Intersect.DefaultTolerance)
        {
            throw new GeometryException(
                GeometryError.CoincidentPoints, "The first and the last point of the curve coincide: it has no chord.");
        }

        var line = chord.Line;
        var along = new double[points.Count];
        var height = new double[points.Count];
        for (var i = 0; i < along.Length; i++)
        {
            (along[i], height[i]) = (line.Along(points[i]), line.SignedDistance(points[i]));
            if (i > 0 && along[i] <= along[i - 1])
            {
                throw Backward(points, i);
            }
        }

        return new(chord, PolynomialFit.Fit(along, height, options));
    }

    /// <summary>The point of the fitted curve at a fraction of the chord: 0 at the first measured point's foot, 1 at the last.</summary>
    public Point2 At(double fraction)
    {
        var line = Chord.Line;
        var along = fraction * Chord.Length;
        return line.At(along) + (line.Normal * Polynomial.Evaluate(along));
    }

    /// <summary>Unit direction of the fitted curve at a fraction of the chord, in the order of the points.</summary>
    public Vector2 TangentAt(double fraction)
    {
        var line = Chord.Line;
        return (line.Direction + (line.Normal * Polynomial.Derivative(fraction * Chord.Length))).Normalize();
    }

    private static GeometryException Backward(IReadOnlyList<Point2> points, int index) =>
        points[index].DistanceTo(points[index - 1]) <= Intersect.DefaultTolerance
            ? new(
                GeometryError.CoincidentPoints,
                string.Create(CultureInfo.InvariantCulture, $"Points {index} and {index + 1} of the curve coincide."))
            : new(
                GeometryError.FoldedCurve,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Point {index + 1} of the curve lies no farther along its chord than point {index}: the points are out of order or "
                        + $"the curve turns back."));
}
