namespace ErrorMatching.Freeform.Tests;

public sealed class OutlyingPointsTests
{
    private const int Seeds = 20;

    /// <summary>Points along u and v; noise in millimeters.</summary>
    public static TheoryData<int, int, double> Grids => new(
        from size in new[] { (10, 7), (7, 7), (6, 5), (15, 2) }
        from noise in new[] { 0, 0.00025, 0.001 }
        select (size.Item1, size.Item2, noise));

    // Fields that are no touch gone wrong: the sizes of their figures do not matter to the test, but the largest is 1.
    private static (string Name, Func<Random, Func<double, double, double>> Of)[] Fields { get; } =
    [
        ("nothing", _ => (_, _) => 0),
        ("tilt", r => Plane(r)),
        ("parabola", r => Plane(r) is var p ? (x, y) => p(x, y) * p(x, y) : null!),
        ("kink along u", r => At(r) is var at ? (x, y) => Math.Abs(x - at.X) : null!),
        ("kink along v", r => At(r) is var at ? (x, y) => Math.Abs(y - at.Y) : null!),
        ("kinks both ways", r => At(r) is var at ? (x, y) => Math.Abs(x - at.X) + Math.Abs(y - at.Y) : null!),
        ("oblique kink", r => Plane(r) is var p ? (x, y) => Math.Abs(p(x, y)) : null!),
        ("bend behind an oblique line", r => Plane(r) is var p ? (x, y) => Math.Max(0, p(x, y)) : null!),
        ("cone", r => At(r) is var at ? (x, y) => Math.Sqrt(((x - at.X) * (x - at.X)) + ((y - at.Y) * (y - at.Y))) : null!),
        (
            "hump",
            r => At(r) is var at
                ? (x, y) => Math.Exp(-(((x - at.X) * (x - at.X)) + ((y - at.Y) * (y - at.Y))) / (2 * 0.27 * 0.27))
                : null!),
        ("falling off from an edge", _ => (x, _) => Math.Exp(-x / 0.15)),
        ("falling off from a corner", _ => (x, y) => Math.Exp(-(x + y) / 0.4)),
        ("step along v", r => At(r) is var at ? (_, y) => y > at.Y ? 1 : 0 : null!),
        ("step along u", r => At(r) is var at ? (x, _) => x > 0.05 + (0.8 * at.X) ? 1 : 0 : null!),
        ("waves", r => At(r) is var at ? (x, y) => Math.Sin(5 * (x + at.X)) * Math.Cos(5 * (y + at.Y)) : null!),
    ];

    [Theory]
    [MemberData(nameof(Grids))]
    public void No_point_of_a_field_with_noise_is_outlying(int countU, int countV, double noise)
    {
        foreach (var (name, of) in Fields)
        {
            for (var seed = 1; seed <= Seeds; seed++)
            {
                var field = of(new Random(seed));
                var shape = new TrueShape(name, (x, y) => 0.025 * field(x / TrueShape.LengthX, y / TrueShape.LengthY));
                Assert.True(Outlying(shape.Samples(countU, countV, noise, seed)).Count == 0, $"{name}, seed {seed}");
            }
        }

        foreach (var shape in TrueShape.MachineErrors.Concat(Enumerable.Range(1, Seeds).Select(RandomShape.MachineError)))
        {
            Assert.True(Outlying(shape.Samples(countU, countV, noise)).Count == 0, shape.Name);
        }
    }

    // The shapes of the fits' tests, ten times as large as any error, with breaks in all directions.
    [Fact]
    public void No_point_of_a_shape_with_breaks_or_waves_is_outlying()
    {
        for (var seed = 1; seed <= Seeds; seed++)
        {
            foreach (var shape in new[]
            {
                RandomShape.Break(seed),
                RandomShape.ObliqueBreak(seed),
                RandomShape.Waves(seed),
                RandomShape.BreakAmongWaves(seed)
            })
            {
                Assert.True(Outlying(shape.Samples(noise: 0.001, seed: seed)).Count == 0, shape.Name);
                Assert.True(Outlying(shape.Samples(noise: 0.001, seed: seed, ragged: true)).Count == 0, shape.Name);
            }
        }
    }

    [Fact]
    public void No_point_of_noise_alone_is_outlying_whatever_its_size()
    {
        var nothing = new TrueShape("nothing", (_, _) => 0);
        for (var seed = 1; seed <= 300; seed++)
        {
            Assert.True(Outlying(nothing.Samples(noise: seed % 3 == 0 ? 0.05 : 0.003, seed: seed)).Count == 0, $"{seed}");
        }
    }

    // Where the field spans 25 um: in the middle, at edges, in corners and beside them. In a corner where the field is steep 20 um more may
    // bring a point to just what two of its neighbors have, and it does not stand alone.
    [Theory]
    [InlineData(0.02, 2)]
    [InlineData(-0.02, 2)]
    [InlineData(0.03, 0)]
    [InlineData(0.15, 0)]
    [InlineData(-0.15, 0)]
    public void A_bad_point_is_found_wherever_it_lies_and_no_other_one(double off, int missed)
    {
        var misses = 0;
        for (var seed = 1; seed <= Seeds; seed++)
        {
            var samples = Spanning(seed, 0.025).Samples(noise: seed % 2 == 0 ? 0.001 : 0.00025, seed: seed);
            for (var bad = 0; bad < samples.Length; bad++)
            {
                var points = Outlying(With(samples, (bad, off)));
                if (points.Count == 0)
                {
                    misses++;
                    continue;
                }

                var found = Assert.Single(points);
                Assert.Equal(bad + 1, found.Sample.Point);

                // What its neighbors say is what was there, but for noise and for what a parabola misses.
                Assert.Equal(samples[bad].ErrorMm, found.SaidMm, 0.009);
                Assert.Equal(off, found.OffMm, 0.009);
            }
        }

        Assert.True(misses <= missed, $"{misses} of {70 * Seeds}");
    }

    [Theory]
    [InlineData(0.06, 0.06, 3)]
    [InlineData(0.15, 0.03, 3)]
    [InlineData(0.06, -0.06, 1)]
    [InlineData(0.15, -0.03, 1)]
    public void Two_bad_points_do_not_hide_each_other(double first, double second, int apart)
    {
        for (var seed = 1; seed <= Seeds; seed++)
        {
            var random = new Random(seed);
            var samples = Spanning(seed, 0.025).Samples(noise: 0.001, seed: seed);
            var (i, j) = (random.Next(10 - apart), random.Next(7));
            var (a, b) = ((j * 10) + i, (j * 10) + i + apart);
            Assert.Equal([a + 1, b + 1], Outlying(With(samples, (a, first), (b, second))).Select(p => p.Sample.Point));
        }
    }

    // The formula against a fit of the same columns with unknown coefficients and all weights,
    // and the variance against points that are moved one by one.
    [Fact]
    public void Prediction_and_leverage_are_those_of_the_local_fit()
    {
        var samples = TrueShape.MachineErrors[2].Samples(noise: 0.001);
        var prediction = new NeighborPrediction(samples);
        foreach (var k in new[] { 0, 5, 34, 69 })
        {
            var others = samples.Select((s, m) => (Dx: (s.I - samples[k].I) * 1.0, Dy: (s.J - samples[k].J) * 1.0, s.ErrorMm, m))
                .Where(o => o.m != k)
                .OrderBy(o => (o.Dx * o.Dx) + (o.Dy * o.Dy))
                .ToArray();
            var far = Distance(others[NeighborPrediction.Neighbors - 1]);

            // No tie at the border, or which points count would be a matter of order: that is left to the other tests.
            if (far >= Distance(others[NeighborPrediction.Neighbors]) - 1e-9)
            {
                continue;
            }

            var near = others[..NeighborPrediction.Neighbors];
            var roots = near.Select(o => Math.Pow(1 - Math.Pow(Distance(o) / (1.2 * far), 3), 1.5)).ToArray();
            double[] Column(Func<double, double, double> term) => [.. near.Select((o, m) => roots[m] * term(o.Dx, o.Dy))];
            double[][] columns = [
                Column((_, _) => 1),
                Column((x, _) => x),
                Column((_, y) => y),
                Column((x, _) => x * x),
                Column((x, y) => x * y),
                Column((_, y) => y * y)];
            var said = LeastSquares.Solve(columns, [.. near.Select((o, m) => roots[m] * o.ErrorMm)])!.Coefficients[0];
            var leverage = Enumerable.Range(0, near.Length).Sum(n => Math.Pow(
                LeastSquares.Solve(columns, [.. near.Select((_, m) => m == n ? roots[m] : 0)])!.Coefficients[0], 2));

            Assert.Equal(samples[k].ErrorMm - said, prediction.Residuals[k], 12);
            Assert.Equal(prediction.Residuals[k] / Math.Sqrt(1 + leverage), prediction.Standardized[k], 12);
        }

        static double Distance((double Dx, double Dy, double ErrorMm, int M) o) => Math.Sqrt((o.Dx * o.Dx) + (o.Dy * o.Dy));
    }

    [Theory]
    [InlineData(2, 20)]
    [InlineData(20, 2)]
    [InlineData(6, 7)]
    public void A_quadratic_is_predicted_exactly_on_any_grid(int countU, int countV)
    {
        var samples = new TrueShape(
            "quadratic",
            (x, y) => 0.01 + (0.0003 * x) - (0.0002 * y) + (0.00001 * x * x) + (0.00002 * x * y) - (0.00001 * y * y))
            .Samples(countU, countV);
        Assert.All(new NeighborPrediction(samples).Residuals, r => Assert.Equal(0, r, 11));
    }

    [Fact]
    public void Points_on_one_line_and_in_one_place_do_no_harm()
    {
        ErrorSample[] Line(int count) =>
            [.. new TrueShape("nothing", (_, _) => 0).Samples(count, 2, 0.0001).Take(count).Select(s => s with { V = 0 })];
        var few = Line(29);
        Assert.Equal(15, Assert.Single(Outlying(With(few, (14, 1)))).Sample.Point);
        var enough = Line(30);
        Assert.Equal(15, Assert.Single(Outlying(With(enough, (14, 1)))).Sample.Point);
        ErrorSample[] same = [.. enough.Select(s => s with { U = 0.5, V = 0.5 })];
        Assert.Equal(15, Assert.Single(Outlying(With(same, (14, 1)))).Sample.Point);
    }

    [Fact]
    public void Words_name_the_furthest_with_its_place_and_the_others_by_number()
    {
        var samples = Spanning(1, 0.025).Samples();
        Assert.Matches(@"^Point 35 \(near X33\.333 Y31\.5 Z0\) is \+\d+\.\d µm off along the normal, "
            + @"where the points around it say [+-]\d+\.\d µm; likewise off is point 1$",
            OutlyingPoint.Words(Outlying(With(samples, (34, 0.15), (0, 0.06)))));
        Assert.EndsWith(
            "likewise off are points 1, 60",
            OutlyingPoint.Words(Outlying(With(samples, (34, 0.15), (0, 0.06), (59, 0.09)))),
            StringComparison.Ordinal);
    }

    private static IReadOnlyList<OutlyingPoint> Outlying(IReadOnlyList<ErrorSample> samples) => OutlyingPoints.Find(samples, 0.0001);

    // Errors of a machine whose largest less smallest is what is asked for.
    private static TrueShape Spanning(int seed, double span)
    {
        var shape = RandomShape.MachineError(seed);
        var errors = shape.Samples().Select(s => s.ErrorMm).ToArray();
        return new(shape.Name, (x, y) => span / (errors.Max() - errors.Min()) * shape.Height(x, y));
    }

    private static ErrorSample[] With(ErrorSample[] samples, params (int At, double Off)[] bad)
    {
        var copy = (ErrorSample[])samples.Clone();
        foreach (var (at, off) in bad)
        {
            copy[at] = copy[at] with { ErrorMm = copy[at].ErrorMm + off };
        }

        return copy;
    }

    private static (double X, double Y) At(Random random) => (random.NextDouble(), random.NextDouble());

    private static Func<double, double, double> Plane(Random random)
    {
        var (at, angle) = (At(random), 2 * Math.PI * random.NextDouble());
        return (x, y) => ((x - at.X) * Math.Cos(angle)) + ((y - at.Y) * Math.Sin(angle));
    }
}
