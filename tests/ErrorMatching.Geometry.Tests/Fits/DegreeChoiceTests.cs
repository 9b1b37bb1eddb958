namespace ErrorMatching.Geometry.Tests.Fits;

/// <summary>
/// The chosen degree against the one that is best for the true curve. The truth is known because it is made here: an offset, a tilt and one
/// to three waves of 20 to 60 mm over 30 to 60 mm, 0.02 to 0.15 mm high, with 5 to 15 points and noise.
/// </summary>
public class DegreeChoiceTests
{
    private const int Curves = 200;

    [Theory]
    [InlineData(1, 0.002, false)]
    [InlineData(2, 0.002, false)]
    [InlineData(3, 0.001, false)]
    [InlineData(4, 0.002, true)]
    [InlineData(5, 0.005, true)]
    public void Chosen_degree_is_seldom_much_worse_than_the_best_one(int seed, double noise, bool isStated)
    {
        var random = new Random(seed);
        var ratios = Enumerable.Range(0, Curves).Select(_ => Ratio(Curve.Draw(random, noise), isStated ? noise : 0)).Order().ToArray();
        Assert.InRange(ratios[Curves / 2], 1, 1.05);
        Assert.InRange(ratios[Curves * 95 / 100], 1, 1.6);
    }

    [Fact]
    public void Scale_and_order_of_the_points_do_not_change_the_degree()
    {
        var random = new Random(12);
        for (var i = 0; i < 20; i++)
        {
            var curve = Curve.Draw(random, 0.002);
            var degree = PolynomialFit.Fit(curve.X, curve.Y).Degree;
            Assert.All((double[])[1e-150, 1024, 1e150], scale => Assert.Equal(
                degree,
                PolynomialFit.Fit([.. curve.X.Select(x => 3 + (64 * x)).Reverse()], [.. curve.Y.Select(y => scale * y).Reverse()]).Degree));
        }
    }

    [Fact]
    public void Points_that_cancel_in_every_group_are_a_constant() =>
        Assert.Equal(0, PolynomialFit.Fit([.. Enumerable.Range(0, 80).Select(i => (double)i)], [
            .. Enumerable.Range(0, 80).Select(i => i % 2 == 0 ? 1.0 : -1)]).Degree);

    [Fact]
    public void Many_points_show_a_degree_that_few_do_not()
    {
        static double Wave(double x) => 0.004 * Math.Sin(2 * Math.PI * x / 40);

        // 2000 points know the wave to 0.0003 mm, although each one is off by up to 0.01 mm. Ten of them do not know it.
        var noise = Draw.Noise(7, 2000);
        double[] x = [.. noise.Select((_, i) => i * 0.02)];
        double[] y = [.. x.Select((v, i) => Wave(v) + (0.01 * noise[i]))];
        var many = PolynomialFit.Fit(x, y);
        Assert.InRange(many.Degree, 3, 7);
        Assert.InRange(Math.Sqrt(x.Average(v => Math.Pow(many.Evaluate(v) - Wave(v), 2))), 0, 0.0006);
        int[] few = [.. Enumerable.Range(0, 10).Select(i => 200 * i)];
        Assert.InRange(PolynomialFit.Fit([.. few.Select(i => x[i])], [.. few.Select(i => y[i])]).Degree, 0, 2);
    }

    [Fact]
    public void Stated_uncertainty_tells_noise_from_shape()
    {
        // The same four points are a wave for a good gauge and noise for a poor one.
        double[] x = [0, 10, 20, 30], y = [0.004, -0.005, 0.006, -0.003];
        Assert.Equal(3, PolynomialFit.Fit(x, y, new() { PointUncertaintyMm = 0.0002 }).Degree);
        Assert.Equal(0, PolynomialFit.Fit(x, y, new() { PointUncertaintyMm = 0.01 }).Degree);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(7)]
    public void Points_of_a_polynomial_but_for_rounding_have_its_degree(int degree)
    {
        double[] x = [.. Enumerable.Range(0, 12).Select(i => 0.1 * i)];
        var fit = PolynomialFit.Fit(x, [.. x.Select(v => Math.Round(100 * Math.Pow(v - 0.3, degree), 9))]);
        Assert.Equal(degree, fit.Degree);
    }

    private static double Ratio(Curve curve, double stated)
    {
        // As many coefficients as points are among them: few good points of a curve with waves need every one.
        var best = Enumerable.Range(0, Math.Min(11, curve.X.Length))
            .Min(degree => curve.Error(PolynomialFit.Fit(curve.X, curve.Y, new() { Degree = degree })));
        return curve.Error(PolynomialFit.Fit(curve.X, curve.Y, new() { PointUncertaintyMm = stated })) / best;
    }

    private sealed record Curve(double[] X, double[] Y, double Length, Func<double, double> Truth)
    {
        public static Curve Draw(Random random, double noise)
        {
            double Between(double from, double to) => from + ((to - from) * random.NextDouble());
            double Normal() => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

            var (length, count, height) = (Between(30, 60), random.Next(5, 16), Between(0.02, 0.15));
            var (offset, tilt) = (Between(-height, height), Between(-height, height));
            var waves = Enumerable.Range(0, random.Next(1, 4))
                .Select(_ => (Length: Between(20, 60), Phase: Between(0, 2 * Math.PI), Share: Between(0.2, 1)))
                .ToArray();
            var scale = height / waves.Sum(w => w.Share);
            double Truth(double x) =>
                offset + (tilt * x / length) + waves.Sum(w => scale * w.Share * Math.Sin((2 * Math.PI * x / w.Length) + w.Phase));
            double[] places = [.. Enumerable.Range(0, count).Select(i => length * i / (count - 1))];
            return new(places, [.. places.Select(x => Truth(x) + (noise * Normal()))], length, Truth);
        }

        /// <summary>Root mean square over the whole curve.</summary>
        public double Error(PolynomialFit fit) => Math.Sqrt(
            Enumerable.Range(0, 101).Average(i => Math.Pow(fit.Evaluate(Length * i / 100) - Truth(Length * i / 100), 2)));
    }
}
