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

        var direct = Lot.Of([new(error, _zeros), new(error, _zeros)], U);
        var corrected = Lot.Of([new(error, _zeros), new(left, correction)], U);

        Assert.All(direct.ExpectedMm.Zip(corrected.ExpectedMm), pair => Assert.Equal(pair.First, pair.Second, 1e-12));
    }

    [Fact]
    public void A_large_error_that_repeats_is_expected_again()
    {
        double[] error = [0.2, -0.1, 0.15, -0.05];

        var lot = Lot.Of([.. Enumerable.Repeat(new LotPiece(error, _zeros), 5)], U);

        Assert.All(lot.ExpectedMm.Zip(error), pair => Assert.Equal(pair.Second, pair.First, 0.001));
        Assert.All(lot.UncertaintyMm, u => Assert.InRange(u, 0.0002, 0.002));
    }

    [Fact]
    public void Lengths_have_no_scale_but_the_uncertainty()
    {
        var random = new Random(7);
        LotPiece[] pieces = [.. Enumerable.Range(0, 6).Select(_ => new LotPiece(
            [.. _zeros.Select(_ => 0.01 * random.NextDouble())], _zeros))];

        var lot = Lot.Of(pieces, U);
        var tenfold = Lot.Of([.. pieces.Select(p => p with { ErrorsMm = [.. p.ErrorsMm.Select(e => -10 * e)] })], 10 * U);

        Assert.All(lot.ExpectedMm.Zip(tenfold.ExpectedMm), pair => Assert.Equal(-10 * pair.First, pair.Second, 1e-12));
        Assert.All(lot.UncertaintyMm.Zip(tenfold.UncertaintyMm), pair => Assert.Equal(10 * pair.First, pair.Second, 1e-12));
    }

    [Fact]
    public void A_step_of_all_points_is_reported_at_its_piece()
    {
        var random = new Random(3);
        LotPiece[] pieces = [.. Enumerable.Range(0, 12).Select(k => new LotPiece(
            [.. _zeros.Select(_ => (k < 6 ? 0.0 : 0.012) + (0.002 * (random.NextDouble() - 0.5)))], _zeros))];

        var lot = Lot.Of(pieces, U);

        Assert.Equal(LotEvent.Step, lot.Pieces[6].Event);
        Assert.All(lot.Pieces.Where((_, k) => k != 6), p => Assert.Equal(LotEvent.None, p.Event));
        Assert.All(lot.ExpectedMm, e => Assert.Equal(0.012, e, 0.0015));
    }

    [Fact]
    public void A_steady_drift_is_continued()
    {
        LotPiece[] pieces = [.. Enumerable.Range(0, 20).Select(k => new LotPiece([.. _zeros.Select(_ => 0.001 * k)], _zeros))];

        var lot = Lot.Of(pieces, U);

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
            var lot = Lot.Of(pieces, U);
            inside += Math.Abs(lot.ExpectedMm[0] - truth) <= 1.96 * lot.UncertaintyMm[0] ? 1 : 0;
            all++;
        }

        Assert.InRange((double)inside / all, 0.88, 1.0);
    }

    [Fact]
    public void Pieces_with_different_points_are_no_lot()
    {
        Assert.Throws<ArgumentException>(() => Lot.Of([], U));
        Assert.Throws<ArgumentException>(() => Lot.Of([new([], [])], U));
        Assert.Throws<ArgumentException>(() => Lot.Of([new([1, 2], [0, 0]), new([1], [0])], U));
        Assert.Throws<ArgumentException>(() => Lot.Of([new([1, 2], [0])], U));
        Assert.Throws<ArgumentOutOfRangeException>(() => Lot.Of([new([1], [0])], 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => Lot.Of([new([1], [0])], double.NaN));
    }

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
