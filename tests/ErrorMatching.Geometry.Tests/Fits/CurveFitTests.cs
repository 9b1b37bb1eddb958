using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Fits;

public class CurveFitTests
{
    [Fact]
    public void Parabola_over_any_chord_is_recovered() =>
        Draw.Law(Draw.Transform, t =>
        {
            // Height (x^2 - 100) / 50 over the chord from (-10, 0) to (10, 0), carried anywhere in the plane.
            double[] places = [-10, -7, -2, 0, 3, 8, 10];
            var fit = CurveFit.Fit([.. places.Select(x => t.Apply(new Point2(x, ((x * x) - 100) / 50)))]);
            return fit.Polynomial.Degree == 2 && fit.ResidualStandardDeviation < 1e-12
                && Enumerable.Range(0, 21).All(
                    i => fit.At(i / 20.0).DistanceTo(t.Apply(new Point2(i - 10, ((i - 10) * (i - 10) - 100) / 50.0))) < 1e-9)
                && (fit.TangentAt(0.75) - t.Apply(new Vector2(1, 0.2).Normalize())).Length < 1e-9;
        }, 200);

    [Fact]
    public void Curve_may_stand_upright()
    {
        // A valley along y, as in figure 1 of the paper: no function y(x), but one over its chord.
        var fit = CurveFit.Fit([new(0, 0), new(-2, 5), new(-3, 10), new(-2, 15), new(0, 20)]);
        Assert.Equal(new Segment2(new(0, 0), new(0, 20)), fit.Chord);
        Assert.InRange(fit.At(0.5).X, -3.2, -2.8);
    }

    [Fact]
    public void Residual_is_measured_less_fitted_height_to_the_left_of_the_chord()
    {
        var fit = CurveFit.Fit([new(0, 0), new(1, 1), new(2, 0)], new() { Degree = 0 });
        Assert.Equal([-1 / 3.0, 2 / 3.0, -1 / 3.0], fit.Residuals, (a, b) => Math.Abs(a - b) < 1e-14);
    }

    [Fact]
    public void What_is_no_curve_is_refused_by_name()
    {
        Refused.With(GeometryError.TooFewPoints, () => CurveFit.Fit([new(0, 0), new(1, 1)]));
        Refused.With(GeometryError.CoincidentPoints, () => CurveFit.Fit([new(0, 0), new(1, 1), new(0, 0)]));
        Refused.With(GeometryError.CoincidentPoints, () => CurveFit.Fit([new(0, 0), new(1, 1), new(1, 1), new(2, 0)]));
        Refused.With(GeometryError.FoldedCurve, () => CurveFit.Fit([new(0, 0), new(5, 1), new(4, 2), new(9, 0)]));
        Refused.With(GeometryError.FoldedCurve, () => CurveFit.Fit([new(0, 0), new(5, 1), new(5, 2), new(9, 0)]));
        Refused.With(GeometryError.NotFinite, () => CurveFit.Fit([new(0, 0), new(double.NaN, 1), new(9, 0)]));
        Refused.With(GeometryError.TooFewPoints, () => CurveFit.Fit([new(0, 0), new(5, 1), new(9, 0)], new() { Degree = 3 }));
    }
}
