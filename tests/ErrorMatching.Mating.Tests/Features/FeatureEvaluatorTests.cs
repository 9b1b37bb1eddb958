using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

public sealed class FeatureEvaluatorTests
{
    private static readonly JobTolerance Tolerance = new(new(-0.05, 0.05), ToleranceSource.Stated);

    [Fact]
    public void A_line_has_the_length_between_its_extreme_points_and_the_direction_of_cutting()
    {
        var line = new LineFeature("L1", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2", "3"], LineMethod.Total);

        var evaluation = FeatureEvaluator.Evaluate(
            line, [new(0, 0), new(-5, 0), new(-10, 0)], [new(0, 0.1), new(-5, 0.1), new(-10.2, 0.1)], 0.01);

        AssertQuantity(evaluation, "lengthMm", 10, 10.2);
        AssertQuantity(evaluation, "directionDeg", 180, 180);
        Assert.Equal(0.0141421, evaluation.Quantities[0].StandardUncertainty, 6);
        Assert.True(evaluation.Quantities[1].StandardUncertainty > 0);
        Assert.Equal(3, evaluation.ResidualsMm.Count);
        Assert.Empty(evaluation.Warnings);
    }

    [Fact]
    public void Directions_differ_by_the_short_way_round()
    {
        var line = new LineFeature("L1", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2"], LineMethod.Total);

        var direction = FeatureEvaluator.Evaluate(line, [new(0, 0), new(-10, 0.1)], [new(0, 0), new(-10, -0.1)], 0).Quantities[1];

        // The theoretical line points to 180 - atan(0.01) degrees, the actual one to -180 + atan(0.01).
        Assert.Equal(-1.145877, direction.Deviation, 5);
    }

    [Fact]
    public void An_ordinary_fit_is_made_on_request()
    {
        Point2[] points = [new(0, 0), new(1, 1), new(2, 0), new(3, 2)];

        // Slope of y on x: covariance 2.5 by variance 5. Total least squares gives a steeper line.
        Assert.Equal(0.5, Slope(LineMethod.Ordinary), 9);
        Assert.True(Slope(LineMethod.Total) > 0.55);

        double Slope(LineMethod method)
        {
            var line = new LineFeature("L1", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2", "3", "4"], method);
            return Math.Tan(FeatureEvaluator.Evaluate(line, points, points, 0).Quantities[1].Actual * Math.PI / 180);
        }
    }

    [Fact]
    public void A_triangle_has_an_apex_an_angle_and_flanks()
    {
        var triangle = new TriangleFeature("L2L3", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2"], ["3", "4"]);

        // A right angle about (3, 4), then moved by (0.1, 0.2).
        Point2[] theoretical = [new(0, 7), new(2, 5), new(2, 3), new(-1, 0)];
        var evaluation = FeatureEvaluator.Evaluate(triangle, theoretical, [.. theoretical.Select(p => p + new Vector2(0.1, 0.2))], 0.002);

        AssertQuantity(evaluation, "apexXMm", 3, 3.1);
        AssertQuantity(evaluation, "apexYMm", 4, 4.2);
        AssertQuantity(evaluation, "angleDeg", 90, 90);
        AssertQuantity(evaluation, "firstFlankMm", Math.Sqrt(18), Math.Sqrt(18));
        AssertQuantity(evaluation, "secondFlankMm", Math.Sqrt(32), Math.Sqrt(32));
        Assert.All(evaluation.Quantities, q => Assert.True(q.StandardUncertainty > 0));
        Assert.Equal(4, evaluation.ResidualsMm.Count);
    }

    [Fact]
    public void Flanks_without_an_apex_are_an_error_that_names_the_feature()
    {
        var triangle = new TriangleFeature("notch", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2"], ["3", "4"]);
        Point2[] parallel = [new(0, 0), new(1, 0), new(0, 1), new(1, 1)];

        var e = Assert.Throws<GeometryException>(() => FeatureEvaluator.Evaluate(triangle, parallel, parallel, 0));

        Assert.Equal(GeometryError.NearParallel, e.Error);
        Assert.StartsWith("notch: ", e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_curve_has_a_chord_and_a_length_along_its_fit()
    {
        // The parabola y = x^2 / 2 from -1 to 1 has the length sqrt(2) + asinh(1).
        Point2[] points = [.. Enumerable.Range(-4, 9).Select(i => new Point2(i / 4.0, i * i / 32.0))];
        var curve = new CurveFeature("C1", ["N1"], Tolerance, CoordinatePlane.XY, [.. points.Select((_, i) => $"{i}")], null, null);

        var evaluation = FeatureEvaluator.Evaluate(curve, points, points, 0.001);

        AssertQuantity(evaluation, "chordMm", 2, 2);
        AssertQuantity(evaluation, "arcLengthMm", Math.Sqrt(2) + Math.Asinh(1), Math.Sqrt(2) + Math.Asinh(1));
        Assert.Equal(2, evaluation.Curve!.Polynomial.Degree);
        Assert.Equal(9, evaluation.ResidualsMm.Count);
        Assert.Empty(evaluation.Warnings);
    }

    [Fact]
    public void A_curve_keeps_the_degree_and_the_ridge_that_the_job_fixes()
    {
        Point2[] points = [.. Enumerable.Range(0, 6).Select(i => new Point2(i, Math.Sin(i)))];
        var curve = new CurveFeature("C1", ["N1"], Tolerance, CoordinatePlane.XY, [.. points.Select((_, i) => $"{i}")], 3, 0.5);

        var fit = FeatureEvaluator.Evaluate(curve, points, points, 0).Curve!.Polynomial;

        Assert.Equal((3, 0.5), (fit.Degree, fit.Ridge));
    }

    [Theory]
    [InlineData(20, 0)]
    [InlineData(20.1, 1)]
    public void Fewer_points_than_one_per_5_mm_are_a_warning(double length, int warnings)
    {
        Point2[] places = [.. Enumerable.Range(0, 4).Select(i => new Point2(i * length / 3, 0))];
        var curve = new CurveFeature("C1", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2", "3", "4"], null, null);

        Assert.Equal(warnings, FeatureEvaluator.Evaluate(curve, places, places, 0).Warnings.Count);
    }

    [Fact]
    public void A_curve_that_turns_back_over_its_chord_is_a_warning()
    {
        // Three quarters of a circle.
        Point2[] points = [.. Enumerable.Range(0, 10).Select(i => Point2.Origin + (Vector2.FromDirection(Angle.FromDegrees(i * 30)) * 10))];
        var curve = new CurveFeature("C1", ["N1"], Tolerance, CoordinatePlane.XY, [.. points.Select((_, i) => $"{i}")], null, null);

        var evaluation = FeatureEvaluator.Evaluate(curve, points, points, 0);

        Assert.Null(evaluation.Curve);
        AssertQuantity(evaluation, "chordMm", Math.Sqrt(200), Math.Sqrt(200));
        var warning = Assert.Single(evaluation.Warnings);
        Assert.Equal("folded-curve", warning.Code);
        Assert.Equal(["C1"], warning.Values);
    }

    [Fact]
    public void There_must_be_as_many_points_as_the_feature_has()
    {
        var line = new LineFeature("L1", ["N1"], Tolerance, CoordinatePlane.XY, ["1", "2"], LineMethod.Total);

        Assert.Throws<ArgumentException>(() => FeatureEvaluator.Evaluate(line, [new(0, 0), new(1, 0)], [new(0, 0)], 0));
    }

    private static void AssertQuantity(FeatureEvaluation evaluation, string name, double theoretical, double actual)
    {
        var quantity = Assert.Single(evaluation.Quantities, q => q.Name == name);
        Assert.Equal(theoretical, quantity.Theoretical, 9);
        Assert.Equal(actual, quantity.Actual, 9);
        Assert.Equal(theoretical - actual, quantity.Deviation, 9);
    }
}
