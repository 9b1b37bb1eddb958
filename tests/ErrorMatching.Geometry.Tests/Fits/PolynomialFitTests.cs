using FsCheck.Fluent;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Geometry.Tests.Fits;

public class PolynomialFitTests
{
    private static readonly double[] Places = [-3, -1.5, 0, 0.7, 2, 3.1, 4.9, 6];

    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 0)]
    [InlineData(3, 0)]
    [InlineData(6, 0)]
    [InlineData(2, 1e-3)]
    [InlineData(4, 0.01)]
    [InlineData(6, 1)]
    public void Closed_form_leave_one_out_equals_refitting_without_the_point(int degree, double ridge) =>
        Draw.Law(FsCheck.Fluent.Gen.Choose(0, 100_000), seed =>
        {
            var y = Draw.Noise(seed, Places.Length);
            var fit = PolynomialFit.Fit(Places, y, new() { Degree = degree, Ridge = ridge });
            var sum = 0.0;
            for (var i = 0; i < Places.Length; i++)
            {
                sum += Math.Pow(y[i] - Penalized(Places, y, degree, ridge, i)(Places[i]), 2);
            }

            return Math.Abs(fit.LeaveOneOutRms!.Value - Math.Sqrt(sum / Places.Length)) < 1e-8 * (1 + Math.Sqrt(sum));
        }, 50);

    [Theory]
    [InlineData(3, 0.02)]
    [InlineData(5, 0.5)]
    public void Ridge_makes_the_penalized_sum_least(int degree, double ridge)
    {
        var y = Draw.Noise(5, Places.Length);
        var fit = PolynomialFit.Fit(Places, y, new() { Degree = degree, Ridge = ridge });
        var independent = Penalized(Places, y, degree, ridge, -1);
        for (var x = -3.0; x <= 6; x += 0.5)
        {
            Assert.Equal(independent(x), fit.Evaluate(x), 9);
        }

        for (var i = 0; i < Places.Length; i++)
        {
            Assert.Equal(y[i] - independent(Places[i]), fit.Residuals[i], 9);
        }

        var effective = 1 + Enumerable.Range(1, degree).Sum(k => 1 / (1 + (ridge * Math.Pow(k, 4))));
        Assert.Equal(effective, fit.EffectiveDegreesOfFreedom, 12);
        Assert.Equal(Math.Sqrt(fit.Residuals.Sum(r => r * r) / (Places.Length - effective)), fit.ResidualStandardDeviation, 12);
    }

    [Fact]
    public void Constant_is_never_penalized()
    {
        var y = Draw.Noise(2, Places.Length);
        var fit = PolynomialFit.Fit(Places, y, new() { Degree = 4, Ridge = 1e9 });
        Assert.Equal(y.Average(), fit.Evaluate(1), 6);
    }

    [Fact]
    public void Polynomial_is_recovered_with_its_degree() =>
        Draw.Law(FsCheck.Fluent.Gen.Choose(0, 5).Zip(FsCheck.Fluent.Gen.Choose(0, 100_000)), p =>
        {
            var truth = new Polynomial([.. Draw.Noise(p.Item2, p.Item1 + 1).Select(c => c + Math.Sign(c))]);
            var fit = PolynomialFit.Fit(Places, [.. Places.Select(truth.Evaluate)], new() { Ridge = null });
            return fit.Degree == truth.Degree && fit.Ridge == 0
                && fit.Coefficients.Zip(truth.Coefficients).All(c => Math.Abs(c.First - c.Second) < 1e-10)
                && Math.Abs(fit.Derivative(1.3) - truth.Derivative().Evaluate(1.3)) < 1e-9;
        }, 300);

    [Fact]
    public void Automatic_choice_has_the_lowest_leave_one_out_error()
    {
        for (var seed = 0; seed < 20; seed++)
        {
            var noise = Draw.Noise(seed, 14);
            double[] x = [.. Enumerable.Range(0, 14).Select(i => i * 5.0)];
            double[] y = [.. x.Select((v, i) => Math.Sin(v / 20) + (0.05 * noise[i]))];
            var chosen = PolynomialFit.Fit(x, y, new() { Ridge = null });
            for (var degree = 0; degree <= 10; degree++)
            {
                foreach (var ridge in (double[])[0, 1e-6, 1e-4, 1e-2, 1])
                {
                    var other = PolynomialFit.Fit(x, y, new() { Degree = degree, Ridge = ridge });
                    Assert.True(chosen.LeaveOneOutRms <= other.LeaveOneOutRms * (1 + 1e-5), $"degree {degree}, ridge {ridge}");
                }
            }
        }
    }

    [Fact]
    public void Maximum_degree_limits_the_choice() =>
        Assert.Equal(2, PolynomialFit.Fit(Places, [.. Places.Select(x => x * x * x)], new() { MaxDegree = 2 }).Degree);

    [Fact]
    public void Fixed_degree_may_still_choose_its_ridge()
    {
        var fit = PolynomialFit.Fit(Places, Draw.Noise(1, Places.Length), new() { Degree = 5, Ridge = null });
        Assert.Equal(5, fit.Degree);
        Assert.True(fit.Ridge > 0);
    }

    [Fact]
    public void Shift_and_scale_of_the_abscissa_leave_the_fitted_values() =>
        Draw.Law(FsCheck.Fluent.Gen.Choose(-1000, 1000).Zip(FsCheck.Fluent.Gen.Choose(1, 100)).Zip(FsCheck.Fluent.Gen.Choose(0, 1000)), p =>
        {
            var ((shift, scale), seed) = p;
            var y = Draw.Noise(seed, Places.Length);
            var options = new PolynomialFitOptions { Degree = 4, Ridge = 0.001 };
            var (fit, moved) = (
                PolynomialFit.Fit(Places, y, options), PolynomialFit.Fit([.. Places.Select(x => shift + (scale * x))], y, options));
            return Places.All(x => Math.Abs(fit.Evaluate(x) - moved.Evaluate(shift + (scale * x))) < 1e-10
                && Math.Abs(fit.Derivative(x) - (scale * moved.Derivative(shift + (scale * x)))) < 1e-8
                && Math.Abs(fit.StandardErrorAt(x) - moved.StandardErrorAt(shift + (scale * x))) < 1e-10)
                && Math.Abs(fit.LeaveOneOutRms!.Value - moved.LeaveOneOutRms!.Value) < 1e-10
                    && Math.Abs(fit.Condition - moved.Condition) < 1e-6;
        }, 200);

    [Fact]
    public void Ordinates_scale_through() =>
        Draw.Law(FsCheck.Fluent.Gen.Choose(0, 1000), seed =>
        {
            var y = Draw.Noise(seed, Places.Length);
            var options = new PolynomialFitOptions { Ridge = null };
            var (fit, scaled) = (PolynomialFit.Fit(Places, y, options), PolynomialFit.Fit(Places, [.. y.Select(v => 1024 * v)], options));
            return fit.Degree == scaled.Degree
                && fit.Ridge == scaled.Ridge
                && fit.Coefficients.Select(c => 1024 * c).SequenceEqual(scaled.Coefficients);
        }, 200);

    [Fact]
    public void Condition_is_that_of_the_design_in_mapped_powers()
    {
        var fit = PolynomialFit.Fit(Places, Draw.Noise(3, Places.Length), new() { Degree = 4 });
        var design = Matrix<double>.Build.Dense(Places.Length, 5, (i, k) => Math.Pow((Places[i] - 1.5) / 4.5, k));
        Assert.Equal(design.ConditionNumber(), fit.Condition, 9);
    }

    [Fact]
    public void Standard_error_at_a_place_is_that_of_the_textbook()
    {
        // sigma^2 v^T (A^T A)^-1 v with the design in powers of x.
        var fit = PolynomialFit.Fit(Places, Draw.Noise(3, Places.Length), new() { Degree = 2 });
        var design = Matrix<double>.Build.Dense(Places.Length, 3, (i, k) => Math.Pow(Places[i], k));
        var covariance = (design.TransposeThisAndMultiply(design)).Inverse() * Math.Pow(fit.ResidualStandardDeviation, 2);
        foreach (var x in (double[])[-3, 0.2, 5, 8])
        {
            var v = Vector<double>.Build.Dense([1, x, x * x]);
            Assert.Equal(Math.Sqrt(v * covariance * v), fit.StandardErrorAt(x), 10);
        }

        Assert.Equal(
            [.. Enumerable.Range(0, 3).Select(k => Math.Sqrt(covariance[k, k]))],
            fit.StandardErrors.ToArray(),
            (a, b) => Math.Abs(a - b) < 1e-12);
    }

    [Fact]
    public void Stated_uncertainty_counts_where_the_residuals_show_less()
    {
        var options = new PolynomialFitOptions { Degree = 1, PointUncertaintyMm = 0.004 };
        var fit = PolynomialFit.Fit([-1, 0, 1, 2], [1, 2, 3, 4], options);
        Assert.Equal(0.002, fit.StandardErrorAt(0.5), 12);
        Assert.Equal(0, fit.ResidualStandardDeviation, 15);
    }

    [Fact]
    public void As_many_coefficients_as_points_leave_no_residual_and_no_leave_one_out_error()
    {
        var fit = PolynomialFit.Fit([0, 1, 2], [5, -1, 7], new() { Degree = 2 });
        Assert.Null(fit.LeaveOneOutRms);
        Assert.Equal(0, fit.ResidualStandardDeviation);
        Assert.Equal(-1, fit.Evaluate(1), 12);
        Assert.Equal([5, -13, 7], fit.Coefficients.Select(c => Math.Round(c, 12)));
    }

    [Fact]
    public void One_point_is_a_constant()
    {
        var fit = PolynomialFit.Fit([3.0], [7.0]);
        Assert.Equal((0, 7.0), (fit.Degree, fit.Evaluate(100)));
        Assert.Equal(0, fit.Derivative(3));
    }

    [Fact]
    public void Repeated_abscissae_are_averaged() => Assert.Equal(2.5, PolynomialFit.Fit([1.0, 1, 1, 1], [1.0, 2, 3, 4]).Evaluate(1), 14);

    [Fact]
    public void What_cannot_be_fitted_is_refused_by_name()
    {
        Refused.With(GeometryError.TooFewPoints, () => PolynomialFit.Fit((double[])[], []));
        Refused.With(GeometryError.TooFewPoints, () => PolynomialFit.Fit([1.0, 2], [1.0, 2], new() { Degree = 2 }));
        Refused.With(GeometryError.RankDeficient, () => PolynomialFit.Fit([1.0, 2, 2, 1], [1.0, 2, 3, 4], new() { Degree = 2 }));
        Refused.With(GeometryError.CoincidentPoints, () => PolynomialFit.Fit([1.0, 1, 1], [2.0, 2, 2], new() { Degree = 1 }));
        Refused.With(GeometryError.NotFinite, () => PolynomialFit.Fit([1.0, double.NaN], [1.0, 2]));
        Refused.With(GeometryError.NotFinite, () => PolynomialFit.Fit([1.0, 2], [double.PositiveInfinity, 2]));
        Assert.Throws<ArgumentException>(() => PolynomialFit.Fit([1.0, 2], [1.0]));
        Assert.Throws<ArgumentOutOfRangeException>(() => PolynomialFit.Fit([1.0, 2], [1.0, 2], new() { Degree = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => PolynomialFit.Fit([1.0, 2], [1.0, 2], new() { MaxDegree = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => PolynomialFit.Fit([1.0, 2], [1.0, 2], new() { Ridge = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => PolynomialFit.Fit([1.0, 2], [1.0, 2], new() { PointUncertaintyMm = double.NaN }));
    }

    /// <summary>
    /// An independent fit: the penalty matrix made from an orthonormal basis by QR over all points, then the normal equations over the
    /// points that are kept, by a dense solver.
    /// </summary>
    private static Func<double, double> Penalized(double[] x, double[] y, int degree, double ridge, int leftOut)
    {
        double Mapped(double v) => (v - 1.5) / 4.5;
        var design = Matrix<double>.Build.Dense(x.Length, degree + 1, (i, k) => Math.Pow(Mapped(x[i]), k));
        var toOrthonormal = design.QR(MathNet.Numerics.LinearAlgebra.Factorization.QRMethod.Thin).R;
        var weights = Matrix<double>.Build.DenseOfDiagonalArray([.. Enumerable.Range(0, degree + 1).Select(k => ridge * Math.Pow(k, 4))]);
        var penalty = toOrthonormal.Transpose() * weights * toOrthonormal;
        var keep = Enumerable.Range(0, x.Length).Where(i => i != leftOut).ToArray();
        var kept = Matrix<double>.Build.DenseOfRows(keep.Select(design.Row));
        var right = kept.Transpose() * Vector<double>.Build.DenseOfEnumerable(keep.Select(i => y[i]));
        var solution = ((kept.Transpose() * kept) + penalty).Solve(right);
        return v => Enumerable.Range(0, degree + 1).Sum(k => solution[k] * Math.Pow(Mapped(v), k));
    }
}
