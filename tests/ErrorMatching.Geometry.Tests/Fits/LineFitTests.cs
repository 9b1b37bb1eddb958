using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Fits;

public class LineFitTests
{
    private static readonly Point2[] Staircase = [new(0, 0), new(1, 1), new(2, 1), new(3, 2)];

    [Fact]
    public void Norris_comes_out_as_certified()
    {
        // The certified set is decimal; rounding it to doubles alone costs the fifteenth digit.
        var set = NistSet.Read("Norris");
        var fit = LineFit.Ordinary([.. set.X.Zip(set.Y, (x, y) => new Point2(x.ToDouble(), y.ToDouble()))]);
        var equation = fit.Equation!.Value;
        Assert.True(NistSet.Digits(equation.Intercept, set.Coefficients[0]) > 12);
        Assert.True(NistSet.Digits(equation.Slope, set.Coefficients[1]) > 14);
        Assert.True(NistSet.Digits(equation.InterceptStandardError, set.StandardErrors[0]) > 12.5);
        Assert.True(NistSet.Digits(equation.SlopeStandardError, set.StandardErrors[1]) > 12.5);
        Assert.True(NistSet.Digits(fit.ResidualStandardDeviation, set.ResidualStandardDeviation) > 12.5);
    }

    [Fact]
    public void Staircase_has_the_slope_that_equation_4_gives()
    {
        // n = 4, sum x = 6, sum y = 4, sum xy = 9, sum x^2 = 14: slope = (36 - 24) / (56 - 36) = 0.6, intercept = 1 - 0.9 = 0.1.
        var equation = LineFit.Ordinary(Staircase).Equation!.Value;
        Assert.Equal(0.6, equation.Slope, 14);
        Assert.Equal(0.1, equation.Intercept, 14);
    }

    [Fact]
    public void Errors_of_the_equation_are_those_of_position_and_direction_seen_across_the_line()
    {
        // sigma = 2 and Sxx = 5: the slope is known to 2 / sqrt 5, the direction to that times cos^2 = 1 / 1.36, the height at the centroid
        // to 1, across the line to 1 / sqrt 1.36.
        var fit = LineFit.Ordinary(Staircase, 2);
        Assert.Equal(2 / Math.Sqrt(5), fit.Equation!.Value.SlopeStandardError, 14);
        Assert.Equal(2 * Math.Sqrt(0.25 + (2.25 / 5)), fit.Equation.Value.InterceptStandardError, 14);
        Assert.Equal(2 / Math.Sqrt(5) / 1.36, fit.AngleStandardError.Radians, 14);
        Assert.Equal(1 / Math.Sqrt(1.36), fit.OffsetStandardError, 14);
    }

    [Fact]
    public void Staircase_has_the_principal_axis_of_its_scatter()
    {
        // Sxx = 5, Sxy = 3, Syy = 2: tan(2 a) = 6 / 3. The smaller eigenvalue (7 - sqrt 45) / 2 is the sum of squared distances.
        var fit = LineFit.Total(Staircase);
        Assert.Equal(Math.Atan2(6, 3) / 2, fit.Line.Direction.Direction.Radians, 14);
        Assert.Equal((7 - Math.Sqrt(45)) / 2, fit.Residuals.Sum(r => r * r), 13);
        Assert.Equal(Math.Sqrt((7 - Math.Sqrt(45)) / 4), fit.ResidualStandardDeviation, 13);
        Assert.Equal(7 / Math.Sqrt(45), fit.Condition, 13);
        Assert.Equal(fit.ResidualStandardDeviation / 2, fit.OffsetStandardError, 14);
        Assert.Equal(fit.ResidualStandardDeviation / Math.Sqrt((7 + Math.Sqrt(45)) / 2), fit.AngleStandardError.Radians, 14);
    }

    [Fact]
    public void Condition_of_an_ordinary_fit_is_that_of_its_design()
    {
        // The design with the columns 1 and x has the Gram matrix [4 6; 6 14], whose eigenvalues are 9 +- sqrt 61.
        Assert.Equal(Math.Sqrt((9 + Math.Sqrt(61)) / (9 - Math.Sqrt(61))), LineFit.Ordinary(Staircase).Condition, 12);
    }

    [Fact]
    public void Length_lies_between_the_extreme_projected_points()
    {
        var fit = LineFit.Total([new(0, 0.5), new(10, -0.5), new(5, 0), new(0, -0.5), new(10, 0.5)]);
        Assert.Equal(10, fit.Length, 12);
        Assert.Equal(0, fit.Line.Direction.Y, 12);
    }

    [Fact]
    public void Two_points_have_no_residual_and_the_stated_uncertainty()
    {
        var fit = LineFit.Total([new(0, 0), new(0, 10)], 0.002);
        Assert.Equal(0, fit.ResidualStandardDeviation);
        Assert.Equal(0.002 / Math.Sqrt(2), fit.OffsetStandardError, 15);
        Assert.Equal(0.002 / Math.Sqrt(50), fit.AngleStandardError.Radians, 15);
        // At an end of two points the position is that of the end point itself.
        Assert.Equal(0.002, fit.OffsetStandardErrorAt(new(0, 10)), 15);
        Assert.Equal(new Vector2(0, 1), fit.Line.Direction);
    }

    [Fact]
    public void Stated_uncertainty_counts_only_where_it_exceeds_the_residuals()
    {
        var plain = LineFit.Total(Staircase);
        Assert.Equal(plain.OffsetStandardError, LineFit.Total(Staircase, 0.001).OffsetStandardError);
        Assert.Equal(1, LineFit.Total(Staircase, 2).OffsetStandardError, 14);
    }

    [Fact]
    public void Ordinary_residuals_are_measured_less_fitted_y()
    {
        var fit = LineFit.Ordinary(Staircase);
        Assert.Equal([-0.1, 0.3, -0.3, 0.1], fit.Residuals.Select(r => Math.Round(r, 12)));
    }

    [Fact]
    public void Total_fit_moves_with_the_points() =>
        Draw.Law(Draw.Point.ListOf(6).Zip(Draw.Transform), p =>
        {
            var (points, transform) = p;
            var fit = LineFit.Total([.. points]);
            var moved = LineFit.Total([.. points.Select(transform.Apply)]);
            return fit.Condition > 100
                || (Math.Abs(moved.Line.SignedDistance(transform.Apply(fit.Extent.Start))) < 1e-9
                && Math.Abs(moved.Line.SignedDistance(transform.Apply(fit.Extent.End))) < 1e-9
                && Math.Abs(moved.ResidualStandardDeviation - fit.ResidualStandardDeviation) < 1e-9
                && Math.Abs(moved.Length - fit.Length) < 1e-9);
        });

    [Fact]
    public void No_neighboring_line_is_nearer_to_the_points() =>
        Draw.Law(Draw.Point.ListOf(7), points =>
        {
            var fit = LineFit.Total([.. points]);
            var best = fit.Residuals.Sum(r => r * r);
            Line2[] neighbors =
            [
                fit.Line.Offset(0.01), fit.Line.Offset(-0.01),
                new(fit.Centroid, Vector2.FromDirection(fit.Line.Direction.Direction + Angle.FromDegrees(0.1))),
                new(fit.Centroid, Vector2.FromDirection(fit.Line.Direction.Direction - Angle.FromDegrees(0.1))),
            ];
            return neighbors.All(l => points.Sum(q => l.SignedDistance(q) * l.SignedDistance(q)) >= best - 1e-9);
        });

    [Fact]
    public void Exact_line_is_recovered() =>
        Draw.Law(Draw.Line.Zip(Draw.Coordinate.ListOf(5)), p =>
        {
            var (line, places) = p;
            if (places.Max() - places.Min() < 1)
            {
                return true;
            }

            var fit = LineFit.Total([.. places.Select(line.At)]);
            return fit.ResidualStandardDeviation < 1e-12 && Math.Abs(fit.Line.Direction.Cross(line.Direction)) < 1e-12
                && Math.Abs(fit.Length - (places.Max() - places.Min())) < 1e-12;
        });

    [Fact]
    public void Spread_of_repeated_fits_is_the_stated_standard_error()
    {
        // 4000 lines through ten noisy points: the scatter of their position and direction must be what one fit claims, within 5 %.
        var (offsets, angles, claimedOffset, claimedAngle) = (0.0, 0.0, 0.0, 0.0);
        const int count = 4000;
        for (var k = 0; k < count; k++)
        {
            var noise = Draw.Noise(k, 10);
            var fit = LineFit.Total([.. noise.Select((e, i) => new Point2(i, 0.01 * e))]);
            offsets += Math.Pow(fit.Line.SignedDistance(new(4.5, 0)), 2);
            angles += Math.Pow(fit.Line.Direction.Direction.Radians, 2);
            claimedOffset += Math.Pow(fit.OffsetStandardError, 2);
            claimedAngle += Math.Pow(fit.AngleStandardError.Radians, 2);
        }

        Assert.InRange(offsets / claimedOffset, 0.95, 1.05);
        Assert.InRange(angles / claimedAngle, 0.95, 1.05);
    }

    [Fact]
    public void What_cannot_be_a_line_is_refused_by_name()
    {
        Refused.With(GeometryError.TooFewPoints, () => LineFit.Total([new(1, 1)]));
        Refused.With(GeometryError.TooFewPoints, () => LineFit.Ordinary([]));
        Refused.With(GeometryError.CoincidentPoints, () => LineFit.Total([new(1, 1), new(1, 1), new(1, 1)]));
        Refused.With(GeometryError.CoincidentPoints, () => LineFit.Ordinary([new(1, 1), new(1, 1)]));
        Refused.With(GeometryError.NotFinite, () => LineFit.Total([new(1, 1), new(double.NaN, 1)]));
        Refused.With(GeometryError.NotFinite, () => LineFit.Ordinary([new(1, 1), new(2, double.PositiveInfinity)]));
        Refused.With(GeometryError.RankDeficient, () => LineFit.Ordinary([new(5, 1), new(5, 2), new(5, 9)]));
        Refused.With(GeometryError.RankDeficient, () => LineFit.Total([new(1, 0), new(0, 1), new(-1, 0), new(0, -1)]));
        Assert.Throws<ArgumentOutOfRangeException>(() => LineFit.Total(Staircase, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => LineFit.Ordinary(Staircase, double.NaN));
    }

    [Fact]
    public void Vertical_line_is_no_trouble_for_the_total_fit() =>
        Assert.Equal(new Vector2(0, 1), LineFit.Total([new(5, 1), new(5, 2), new(5, 9)]).Line.Direction, (a, b) => (a - b).Length < 1e-15);
}
