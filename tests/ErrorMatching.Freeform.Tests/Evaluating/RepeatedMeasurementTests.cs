namespace ErrorMatching.Freeform.Tests;

public sealed class RepeatedMeasurementTests
{
    [Fact]
    public void Mean_and_spread_are_those_worked_out_by_hand()
    {
        // Two points measured three times: 1 2 3 and 4 4 7 um. Means 2 and 5; squares 2 and 6 over 2 (3 - 1) = 2 um^2.
        var r = RepeatedMeasurement.Of([Of(1, 4), Of(2, 4), Of(3, 7)]);

        Assert.Equal([0.002, 0.005], r.Samples.Select(s => Math.Round(s.ErrorMm, 12)));
        Assert.Equal(0.001 * Math.Sqrt(2), r.StandardDeviationMm, 12);
        Assert.Equal(0.001 * Math.Sqrt(2.0 / 3), r.StandardErrorMm, 12);
        Assert.Empty(r.Outliers);
    }

    [Fact]
    public void A_touch_gone_wrong_is_named_and_counts()
    {
        var random = new Random(1);
        double[] Noise() => [.. Enumerable.Range(0, 30).Select(_ => random.NextDouble())];
        var wrong = Noise();
        wrong[11] += 40;
        var r = RepeatedMeasurement.Of([Of(Noise()), Of(wrong), Of(Noise()), Of(Noise())]);

        Assert.Contains("Point 12 ", Assert.Single(r.Outliers), StringComparison.Ordinal);
        Assert.Contains("measurement 2", r.Outliers[0], StringComparison.Ordinal);
        Assert.InRange(r.Samples[11].ErrorMm, 0.0095, 0.0115);
    }

    [Fact]
    public void Other_points_are_no_repeated_measurement() => Assert.Throws<ArgumentException>(() => RepeatedMeasurement.Of([Of(1, 2), Of(1)]));

    private static IReadOnlyList<ErrorSample> Of(params double[] um) => [.. um.Select((e, i) => new ErrorSample(i + 1, i, 0, i, 0, new(i, 0, 0), new(0, 0, 1), e / 1000))];
}
