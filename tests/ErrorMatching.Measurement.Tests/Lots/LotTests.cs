namespace ErrorMatching.Measurement.Tests;

public sealed class LotTests
{
    private const double U = 0.002;

    private static readonly double[] _zeros = new double[4];

    [Fact]
    public void What_a_program_corrected_is_taken_from_what_its_piece_shows()
    {
        double[] error = [0.02, 0.01, -0.01, 0.03], correction = [-0.019, -0.012, 0.008, -0.031];
        double[] left = [.. error.Zip(correction, (e, c) => e + c)];

        var direct = Lot.Estimate([new(error, _zeros), new(error, _zeros)], U);
        var corrected = Lot.Estimate([new(error, _zeros), new(left, correction)], U);

        Assert.All(direct.ExpectedMm.Zip(corrected.ExpectedMm), pair => Assert.Equal(pair.First, pair.Second, 1e-12));
    }

    // What two pieces differ by has the noise of both: +a and -a about their mean are a variance of 2 a^2 for one degree of freedom.
    [Fact]
    public void The_noise_of_a_point_is_what_two_pieces_differ_by_over_root_2()
    {
        var before = new RecordedPiece("1", U, new([0.010, 0.020], [0, 0]));
        var piece = RecordedPiece.After(before, "2", new([0.017, 0.015], [0.001, -0.001]));

        // 0.006 and -0.004 without the corrections: 0.005 about the mean.
        Assert.Equal(0.005, piece.NoiseMm, 1e-12);
    }

    // Of two pieces, the first one has the stated uncertainty. A large noise must be shown by more than half of the pieces.
    [Theory]
    [InlineData(0.001, 0.001, 0.009)]
    [InlineData(0.001, 0.001, 0.001, 0.009)]
    [InlineData(0.001, 0.001, 0.001, 0.009, 0.009)]
    [InlineData(0.009, 0.001, 0.009, 0.009)]
    public void The_noise_of_a_lot_is_the_lower_median_of_its_pieces(double expected, params double[] noises)
    {
        LotPiece[] values = [.. noises.Select((_, k) => new LotPiece([0.001 * k, -0.001 * k, 0.0005 * k, 0], _zeros))];
        var lot = new MeasuredLot(["1", "2", "3", "4"], [.. values.Zip(noises, (v, n) => new RecordedPiece("", n, v))], _zeros)
            .Estimate(0.0001);
        Assert.Equal(Lot.Estimate(values, expected).UncertaintyMm, lot.UncertaintyMm);
    }

    // The mean of two points has half the variance of one, and the difference to it the other half.
    [Fact]
    public void The_noise_that_is_reported_is_that_of_one_point()
    {
        var random = new Random(5);
        LotPiece[] pieces = [.. Enumerable.Range(0, 60).Select(_ => new LotPiece([U * Normal(random), U * Normal(random)], [0, 0]))];
        Assert.InRange(Lot.Estimate(pieces, U).NoiseMm, 0.9 * U, 1.12 * U);
    }

    [Fact]
    public void A_large_error_that_repeats_is_expected_again()
    {
        double[] error = [0.2, -0.1, 0.15, -0.05];

        var lot = Lot.Estimate([.. Enumerable.Repeat(new LotPiece(error, _zeros), 5)], U);

        Assert.All(lot.ExpectedMm.Zip(error), pair => Assert.Equal(pair.Second, pair.First, 0.001));
        Assert.All(lot.UncertaintyMm, u => Assert.InRange(u, 0.0002, 0.002));
    }

    [Fact]
    public void Lengths_have_no_scale_but_the_uncertainty()
    {
        var random = new Random(7);
        LotPiece[] pieces = [.. Enumerable.Range(0, 6).Select(_ => new LotPiece(
            [.. _zeros.Select(_ => 0.01 * random.NextDouble())], _zeros))];

        var lot = Lot.Estimate(pieces, U);
        var tenfold = Lot.Estimate([.. pieces.Select(p => p with { ErrorsMm = [.. p.ErrorsMm.Select(e => -10 * e)] })], 10 * U);

        Assert.All(lot.ExpectedMm.Zip(tenfold.ExpectedMm), pair => Assert.Equal(-10 * pair.First, pair.Second, 1e-12));
        Assert.All(lot.UncertaintyMm.Zip(tenfold.UncertaintyMm), pair => Assert.Equal(10 * pair.First, pair.Second, 1e-12));
    }

    [Fact]
    public void A_step_of_all_points_is_reported_at_its_piece()
    {
        var random = new Random(3);
        LotPiece[] pieces = [.. Enumerable.Range(0, 12).Select(k => new LotPiece(
            [.. _zeros.Select(_ => (k < 6 ? 0.0 : 0.012) + (0.002 * (random.NextDouble() - 0.5)))], _zeros))];

        var lot = Lot.Estimate(pieces, U);

        Assert.Equal(LotEvent.Step, lot.Pieces[6].Event);
        Assert.All(lot.Pieces.Where((_, k) => k != 6), p => Assert.Equal(LotEvent.None, p.Event));
        Assert.All(lot.ExpectedMm, e => Assert.Equal(0.012, e, 0.0015));
    }

    [Fact]
    public void A_steady_drift_is_continued()
    {
        LotPiece[] pieces = [.. Enumerable.Range(0, 20).Select(k => new LotPiece([.. _zeros.Select(_ => 0.001 * k)], _zeros))];

        var lot = Lot.Estimate(pieces, U);

        Assert.Equal(0.001, lot.DriftMm, 0.0001);
        Assert.All(lot.ExpectedMm, e => Assert.Equal(0.020, e, 0.001));
    }

    // The stated uncertainty covers the truth as often as it says, whatever the process does.
    [Fact]
    public void The_interval_covers_the_error_of_the_process()
    {
        var (inside, all) = (0, 0);
        var random = new Random(11);
        for (var run = 0; run < 60; run++)
        {
            var truth = 0.003 * Normal(random);
            LotPiece[] pieces = [.. Enumerable.Range(0, 8).Select(_ => new LotPiece([truth + (U * Normal(random))], [0.0]))];
            var lot = Lot.Estimate(pieces, U);
            inside += Math.Abs(lot.ExpectedMm[0] - truth) <= 1.96 * lot.UncertaintyMm[0] ? 1 : 0;
            all++;
        }

        Assert.InRange((double)inside / all, 0.88, 1.0);
    }

    [Fact]
    public void Pieces_with_different_points_are_no_lot()
    {
        Assert.Throws<ArgumentException>(() => Lot.Estimate([], U));
        Assert.Throws<ArgumentException>(() => Lot.Estimate([new([], [])], U));
        Assert.Throws<ArgumentException>(() => Lot.Estimate([new([1, 2], [0, 0]), new([1], [0])], U));
        Assert.Throws<ArgumentException>(() => Lot.Estimate([new([1, 2], [0])], U));
        Assert.Throws<ArgumentOutOfRangeException>(() => Lot.Estimate([new([1], [0])], 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => Lot.Estimate([new([1], [0])], double.NaN));
    }

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
