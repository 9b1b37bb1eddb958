using ErrorMatching.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Mating.Tests;

/// <summary>The probability that a pair goes together, against what is known of its boundary by textbook algebra.</summary>
public sealed class PairDrawsTests
{
    private const double Side = 30, U = 0.003;
    private const int PerSide = 9;

    [Fact]
    public void A_predicted_probability_is_the_share_that_goes_together()
    {
        var random = new Random(11);
        var bins = new (int Count, double Predicted, int Observed)[5];
        for (var pair = 0; pair < 500; pair++)
        {
            var (priors, rows) = Measured(random);
            var (mean, covariance) = Textbook(priors, rows);
            var air = -0.002 + (0.018 * random.NextDouble());
            var (samples, factor) = (Samples(k => air + mean[k]), Factor(priors, rows));
            var motions = PairSeatTests.Motions(samples);
            double[] gaps = [.. samples.Select(s => s.GapMm)];
            var predicted = PairDraws.Draw(motions, gaps, [factor], 400).Probability;
            ref var bin = ref bins[Math.Min(4, (int)(predicted * 5))];
            var root = (covariance + (Matrix<double>.Build.DenseIdentity(gaps.Length) * 1e-9)).Cholesky().Factor;
            var seat = motions.Seat(0);
            for (var truth = 0; truth < 10; truth++)
            {
                var off = root * Vector<double>.Build.Dense(gaps.Length, _ => Normal(random));
                seat.Solve(motions.Limits([.. gaps.Select((g, k) => g + off[k])]));
                bin = (bin.Count + 1, bin.Predicted + predicted, bin.Observed + (seat.Value >= 0 ? 1 : 0));
            }
        }

        var told = string.Join(
            "; ",
            bins.Select(b => FormattableString.Invariant(
                $"{b.Count}: {b.Predicted / b.Count:0.000} predicted, {(double)b.Observed / b.Count:0.000} observed")));
        TestContext.Current.TestOutputHelper?.WriteLine(told);
        Assert.All(bins, b => Assert.True(b.Count >= 200 && Math.Abs((b.Predicted - b.Observed) / b.Count) <= 0.06, told));
    }

    [Fact]
    public void The_joint_posterior_is_the_textbook_s()
    {
        var (priors, rows) = Measured(new(3));
        var (mean, covariance) = Textbook(priors, rows);
        var field = new DeviationField(priors, rows, U);
        var joint = field.Together(Places());
        var (places, factor) = (Places(), Factor(priors, rows));
        for (var k = 0; k < places.Length; k++)
        {
            Assert.Equal(mean[k], field.Mean(places[k]), 1e-9);
            Assert.Equal(Math.Sqrt(covariance[k, k]), field.StandardDeviation(places[k][0].Stretch, places[k][0].AlongMm), 1e-8);
            for (var j = 0; j < places.Length; j++)
            {
                Assert.Equal(covariance[k, j], joint.Covariance(k, j), 1e-10);

                // What the factor leaves out is a thousandth of the largest variance.
                Assert.Equal(covariance[k, j], factor.Columns.Sum(c => c[k] * c[j]), 1.001e-3 * covariance.Diagonal().Maximum());
            }
        }

        Assert.InRange(factor.Columns.Count, 8, places.Length - 1);
    }

    [Fact]
    public void A_boss_of_a_known_shape_has_the_probability_of_its_radius()
    {
        // Only the radius is uncertain: the air is its normal distribution.
        var normals = Enumerable.Range(0, 72).Select(i => Vector2.FromDirection(Angle.FromDegrees(5 * i))).ToArray();
        PairSample[] samples = [.. normals.Select(n => new PairSample(Point2.Origin - (n * 10), n, 0.004))];
        var draws = PairDraws.Draw(
            PairSeatTests.Motions(samples), [.. samples.Select(s => s.GapMm)], [new(0, [[.. normals.Select(_ => 0.005)]])]);
        Assert.Equal(0.788, draws.Probability, 0.02);
        Assert.Equal(0.004, draws.MedianMm, 0.0004);
        Assert.Equal(0.004 - (1.96 * 0.005), draws.FromMm, 0.0008);
        Assert.Equal(0.004 + (1.96 * 0.005), draws.ToMm, 0.0008);

        // A shift says nothing: the part follows it.
        var shifted = PairDraws.Draw(
            PairSeatTests.Motions(samples), [.. samples.Select(s => s.GapMm)], [new(0, [[.. normals.Select(n => 0.1 * n.X)]])]);
        Assert.Equal(1, shifted.Probability);
        Assert.Equal(0.004, shifted.FromMm, 1e-8);
    }

    [Fact]
    public void The_same_input_gives_the_same_draws()
    {
        var (priors, rows) = Measured(new(8));
        var samples = Samples(_ => 0.004);
        var (motions, factor) = (PairSeatTests.Motions(samples), Factor(priors, rows));
        double[] gaps = [.. samples.Select(s => s.GapMm)];
        Assert.Equal(PairDraws.Draw(motions, gaps, [factor]), PairDraws.Draw(motions, gaps, [factor]));
    }

    [Fact]
    public void Places_that_are_never_the_tightest_change_nothing()
    {
        // Two sides with much air beside two with little: 2,000 draws without the thinning are those of 256 and less.
        var (priors, rows) = Measured(new(21));
        var samples = Samples(k => k / PerSide % 2 == 0 ? 0.003 : 0.05);
        var (motions, factor) = (PairSeatTests.Motions(samples), Factor(priors, rows));
        double[] gaps = [.. samples.Select(s => s.GapMm)];
        var thinned = PairDraws.Draw(motions, gaps, [factor]);
        var (variates, seat, air) = (new NormalVariates(0x0123456789ABCDEF), motions.Seat(0), new List<double>());
        for (var draw = 0; draw < PairDraws.Count; draw += 2)
        {
            double[] z = [.. factor.Columns.Select(_ => variates.Next())];
            foreach (var sign in (int[])[1, -1])
            {
                seat.Solve(motions.Limits([.. gaps.Select((g, k) => g + (sign * z.Select((v, c) => v * factor.Columns[c][k]).Sum()))]));
                air.Add(seat.Value);
            }
        }

        Assert.Equal(air.Count(a => a >= -1e-9) / 2000.0, thinned.Probability, 0.0011);
        Assert.Equal(air.Order().ElementAt(1000), thinned.MedianMm, 1e-5);
    }

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

    // Four sides of a square key with three points each.
    private static (DeviationPrior[] Priors, BoundaryRow[] Rows) Measured(Random random)
    {
        var (tilt, form, length) = (0.002 + (0.01 * random.NextDouble()), 0.003 * random.NextDouble(), 5 + (10 * random.NextDouble()));
        DeviationPrior[] priors = [
            .. Enumerable.Range(0, 4).Select(_ => new DeviationPrior(
                new BoundaryElement(new(0, 0, [0, Side], []), 0, 0, ElementForm.Straight), tilt, U, [])
            {
                Form = [(form * form, length)]
            })];
        return (
            priors,
            [.. Enumerable.Range(0, 12).Select(i => new BoundaryRow([new(i / 3, 3 + (12 * (i % 3)), 1)], 0.004 * Normal(random)))]);
    }

    private static IReadOnlyList<RowTerm>[] Places() =>
        [
            .. Enumerable.Range(0, 4 * PerSide).Select(
                k => (IReadOnlyList<RowTerm>)[new(k / PerSide, Side * (k % PerSide) / (PerSide - 1), 1)])];

    private static JointFactor Factor(DeviationPrior[] priors, BoundaryRow[] rows) =>
        JointFactor.Factor(0, new DeviationField(priors, rows, U).Together(Places()));

    private static PairSample[] Samples(Func<int, double> gap)
    {
        Point2[] corners = [new(0, 0), new(Side, 0), new(Side, Side), new(0, Side)];
        return [
            .. Places().Select((p, k) =>
            {
                var (from, to) = (corners[k / PerSide], corners[((k / PerSide) + 1) % 4]);
                return new PairSample(from.Lerp(to, p[0].AlongMm / Side), (to - from).Normalize().Left, gap(k));
            })];
    }

    // Rasmussen and Williams (2006), equations 2.23 and 2.24.
    private static (Vector<double> Mean, Matrix<double> Covariance) Textbook(DeviationPrior[] priors, BoundaryRow[] rows)
    {
        RowTerm[] places = [.. Places().Select(p => p[0])], points = [.. rows.Select(r => r.Terms[0])];
        var inverse = (Covariance(points, points) + (Matrix<double>.Build.DenseIdentity(points.Length) * U * U)).Inverse();
        var with = Covariance(places, points);
        return (
            with * inverse * Vector<double>.Build.Dense(rows.Length, i => rows[i].ValueMm),
            Covariance(places, places) - (with * inverse * with.Transpose()));

        Matrix<double> Covariance(RowTerm[] one, RowTerm[] other) => Matrix<double>.Build.Dense(
            one.Length,
            other.Length,
            (i, j) => one[i].Stretch == other[j].Stretch ? priors[one[i].Stretch].Covariance(one[i].AlongMm, other[j].AlongMm) : 0);
    }
}
