using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class RepeatedMeasurementTests
{
    [Fact]
    public void Mean_deviation_and_standard_error_are_those_of_the_book()
    {
        // 2 4 4 4 5 5 7 9: mean 5, sum of squares 32, deviation sqrt(32/7), standard error of the mean sqrt(32/7/8).
        var point = Assert.Single(
            RepeatedMeasurement.Estimate(
                [.. new[] { 2.0, 4, 4, 4, 5, 5, 7, 9 }.Select(e => (IReadOnlyList<ErrorSample>)[Sample(1, e)])]).Points);

        Assert.Equal(5, point.Mean.ErrorMm, 1e-15);
        Assert.Equal(8, point.Count);
        Assert.Equal(Math.Sqrt(32.0 / 7), point.StandardDeviationMm, 1e-14);
        Assert.Equal(Math.Sqrt(32.0 / 7 / 8), point.StandardErrorMm, 1e-14);
    }

    [Fact]
    public void Repeatability_is_pooled_over_the_points()
    {
        // Deviations 1 (three values 0 1 2) and sqrt(2) (two values 0 2): (2 * 1 + 1 * 2) / 3.
        var result = RepeatedMeasurement.Estimate([[Sample(1, 0), Sample(2, 0)], [Sample(1, 1), Sample(2, 2)], [Sample(1, 2)]]);

        Assert.Equal(Math.Sqrt(4.0 / 3), result.RepeatabilityMm, 1e-14);
        Assert.Equal([1, 2], result.Means.Select(m => m.Point));
    }

    [Fact]
    public void An_outlier_is_named_and_stays_in_the_mean()
    {
        var noise = new Noise(1);
        var measurements = Enumerable.Range(0, 4)
            .Select(
                m => (IReadOnlyList<ErrorSample>)[
                    .. Enumerable.Range(1, 20).Select(p => Sample(p, (0.001 * noise.Next()) + (m == 2 && p == 7 ? 0.05 : 0)))])
            .ToArray();
        var result = RepeatedMeasurement.Estimate(measurements);
        var outlier = Assert.Single(result.Outliers);

        Assert.Equal((7, 2), (outlier.Point, outlier.Measurement));
        Assert.InRange(outlier.DifferenceMm, 0.045, 0.055);
        Assert.Equal(measurements.Average(m => m[6].ErrorMm), result.Points[6].Mean.ErrorMm, 1e-15);
    }

    [Fact]
    public void A_point_measured_once_has_no_deviation()
    {
        var result = RepeatedMeasurement.Estimate([[Sample(1, 0.5)]]);

        Assert.True(double.IsNaN(result.Points[0].StandardDeviationMm));
        Assert.True(double.IsNaN(result.RepeatabilityMm));
        Assert.Empty(result.Outliers);
    }

    [Fact]
    public void Doubled_missing_and_infinite_points_are_refused_with_their_place()
    {
        var doubled = Assert.Throws<InputException>(() => RepeatedMeasurement.Estimate([[Sample(1, 0)], [Sample(3, 0), Sample(3, 1)]]));
        Assert.Equal(("doubled-point", "measurement 2"), (doubled.Code, doubled.File));
        Assert.Equal("no-samples", Assert.Throws<InputException>(() => RepeatedMeasurement.Estimate([])).Code);
        Assert.Equal("not-finite", Assert.Throws<InputException>(() => RepeatedMeasurement.Estimate([[Sample(1, double.NaN)]])).Code);
    }

    private static ErrorSample Sample(int point, double error) => new(point, point, 0, 0, 0, new(0, 0, 0), new(0, 0, 1), error);
}
