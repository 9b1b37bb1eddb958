using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>The course of a curve between its key points, against the truth and against a Gaussian process that shares no code with
/// it.</summary>
public sealed class CourseTests
{
    private const int Curves = 300;

    // The ratio that a person sees in the worst cases, of the errors over the whole curve.
    [Theory]
    [InlineData(0.002)]
    [InlineData(0.005)]
    public void The_course_is_as_near_to_the_truth_as_a_reference_process(double noise)
    {
        var (ours, reference) = (new List<double>(), new List<double>());
        for (var seed = 0; seed < Curves; seed++)
        {
            var (truth, along, values) = Curve(seed, noise);
            var element = Element(along[^1]);
            BoundaryRow[] rows = [.. along.Zip(values, (s, v) => new BoundaryRow([new(0, s, 1)], v))];
            var field = new DeviationField(PriorChoice.Of([element], rows, noise).OfCuts, rows, noise);
            var process = ReferenceProcess.Of(along, values, noise);
            ours.Add(Rms(truth, s => field.Mean(0, s), along[^1]));
            reference.Add(Rms(truth, process.At, along[^1]));
        }

        Assert.InRange(At95(ours) / At95(reference), 0.5, 1.2);
        Assert.InRange(Median(ours) / Median(reference), 0.5, 1.2);
    }

    // Curves that are drawn from a process of random scales. A process that is told them is out of reach: even the mean over all scales
    // that the draw could have had, weighed by their likelihood, which no estimate can beat on average, leaves 1.03 to 1.05 times as
    // much as it. Half of the courses are to be within 1.06 of the one that is told, and all together within 1.06 of the best possible.
    [Theory]
    [InlineData(0.002)]
    [InlineData(0.005)]
    public void The_course_is_nearly_as_near_as_that_of_a_process_that_is_told_the_scales(double noise)
    {
        const int Grid = 6;
        var (ours, told, best) = (new List<double>(), new List<double>(), new List<double>());
        for (var seed = 0; seed < Depth.Of(150, Curves); seed++)
        {
            var random = new Random(seed);
            var (length, count) = (35 + (10 * random.NextDouble()), random.Next(5, 15));
            var kernel = Scales(random.NextDouble(), random.NextDouble());
            var (tilt, shift) = (0.05 * Gauss(), 0.1 * Gauss());
            double[] places = [.. Enumerable.Range(0, 201).Select(i => length * i / 200)];
            var drawn = ReferenceProcess.Draw(places, kernel, Gauss);
            double[] along = [.. Enumerable.Range(0, count).Select(i => places[200 * i / (count - 1)])];
            double[] values = [.. along.Select(s => Truth(s) + (noise * Gauss()))];
            BoundaryRow[] rows = [.. along.Zip(values, (s, v) => new BoundaryRow([new(0, s, 1)], v))];
            var field = new DeviationField(PriorChoice.Of([Element(length)], rows, noise).OfCuts, rows, noise);
            var all = ReferenceProcess.Mean(along, values, noise, [
                .. Enumerable.Range(0, Grid * Grid).Select(k => Scales((k % Grid + 0.5) / Grid, (k / Grid + 0.5) / Grid))]);
            ours.Add(Rms(Truth, s => field.Mean(0, s), length));
            told.Add(Rms(Truth, ReferenceProcess.Told(along, values, noise, kernel).At, length));
            best.Add(Rms(Truth, all, length));

            (double Amplitude, double Length) Scales(double a, double b) => (0.005 * Math.Pow(10, a), length * (0.15 + (0.45 * b)));
            double Truth(double s) => shift + (tilt * s / length) + drawn[(int)Math.Round(200 * s / length)];
            double Gauss() => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
        }

        Assert.InRange(Median([.. ours.Zip(told, (a, b) => a / b)]), 1, 1.06);
        Assert.InRange(ours.Average() / best.Average(), 0.99, 1.06);
        Assert.InRange(best.Average() / told.Average(), 1.02, 1.06);
    }

    // Of 300 curves with 101 places each, so that the band holds where nobody measured.
    [Theory]
    [InlineData(0.002)]
    [InlineData(0.005)]
    public void The_band_between_the_points_holds_the_truth(double noise)
    {
        var (inside, all) = (0, 0);
        for (var seed = 0; seed < Curves; seed++)
        {
            var (truth, along, values) = Curve(seed, noise);
            var element = Element(along[^1]);
            BoundaryRow[] rows = [.. along.Zip(values, (s, v) => new BoundaryRow([new(0, s, 1)], v))];
            var field = new DeviationField(PriorChoice.Of([element], rows, noise).OfPiece, rows, noise);
            foreach (var s in Enumerable.Range(0, 101).Select(i => along[^1] * i / 100))
            {
                inside += Math.Abs(field.Mean(0, s) - truth(s)) <= PredictedError.Factor95 * field.StandardDeviation(0, s) ? 1 : 0;
                all++;
            }
        }

        Assert.InRange((double)inside / all, 0.9, 0.99);
    }

    // A scanning probe; a gauge without error is the hardest case for the arithmetic.
    [Fact]
    public void A_thousand_points_without_noise_are_met()
    {
        const double Length = 200;
        double[] along = [.. Enumerable.Range(0, 1000).Select(i => Length * i / 999)];
        BoundaryRow[] rows = [.. along.Select(s => new BoundaryRow([new(0, s, 1)], Truth(s)))];
        var field = new DeviationField(PriorChoice.Of([Element(Length)], rows, 0).OfCuts, rows, 0);

        Assert.All(Enumerable.Range(0, 37), i => Assert.Equal(Truth(5.3 * i), field.Mean(0, 5.3 * i), 2e-4));

        static double Truth(double s) => 0.05 + (0.04 * Math.Sin(s / 9)) + (0.02 * Math.Sin(s / 23));
    }

    // A row of one place with variance V = vague^2 + tilt^2 t^2 and noise u: mean V / (V + u^2) y, variance V u^2 / (V + u^2).
    [Fact]
    public void One_point_on_a_line_follows_the_closed_form()
    {
        var element = new BoundaryElement(Pass(10), 0, 0, ElementForm.Straight);
        BoundaryRow[] rows = [new([new(0, 7.5, 1)], 0.04)];
        var field = new DeviationField([new DeviationPrior(element, 0.3, 0.02, [7.5])], rows, 0.02);
        const double V = 1 + (0.09 * 0.25);

        Assert.Equal(V / (V + 0.0004) * 0.04, field.Mean(0, 7.5), 12);
        Assert.Equal(Math.Sqrt(V * 0.0004 / (V + 0.0004)), field.StandardDeviation(0, 7.5), 12);

        // At the other quarter, the tilt counts against the shift.
        Assert.Equal((1 - (0.09 * 0.25)) / (V + 0.0004) * 0.04, field.Mean(0, 2.5), 12);
    }

    // In the round of a corner, 0.6 of one element and 0.8 of the other: the sum is known to the noise, each of them hardly at all.
    [Fact]
    public void A_point_on_a_corner_says_something_about_both_elements()
    {
        BoundaryElement[] elements = [new(Pass(10), 0, 0, ElementForm.Straight), new(Pass(20), 0, 0, ElementForm.Straight)];
        BoundaryRow[] rows = [new([new(0, 10, 0.6), new(1, 0, 0.8)], 0.1)];
        var field = new DeviationField(
            [new DeviationPrior(elements[0], 0, 0.001, []), new DeviationPrior(elements[1], 0, 0.001, [])], rows, 0.001);

        // Both have the variance 1, so the sum of the squares of the weights is 1 as well.
        Assert.Equal(0.6 * 0.1 / 1.000001, field.Mean(0, 3), 12);
        Assert.Equal(0.8 * 0.1 / 1.000001, field.Mean(1, 3), 12);
        Assert.Equal(Math.Sqrt(1 - (0.36 / 1.000001)), field.StandardDeviation(0, 3), 12);
    }

    // log N(y; 0, C) without its constant, for C = [4 2; 2 5], y = (2, 3): det 16, y' C^-1 y = (5*4 - 2*2*6 + 4*9) / 16 = 2.
    [Fact]
    public void The_evidence_of_two_values_follows_the_closed_form() =>
        Assert.Equal(-(2 + Math.Log(16)) / 2, Evidence.Log([4, 2, 2, 5], [2, 3]), 12);

    // 0.1 t^2 over five places is met exactly by degree 2; by degree 1, the line of least squares is its mean.
    [Theory]
    [InlineData(2, 0.0, 0.1)]
    [InlineData(1, 0.05, 0.05)]
    public void A_fixed_degree_is_a_polynomial_of_least_squares(int degree, double middle, double end)
    {
        double[] along = [0, 5, 10, 15, 20];
        var element = Element(20) with { Degree = degree };
        BoundaryRow[] rows = [.. along.Select(s => new BoundaryRow([new(0, s, 1)], 0.1 * Math.Pow((s - 10) / 10, 2)))];
        var field = new DeviationField(PriorChoice.Of([element], rows, 0.001).OfCuts, rows, 0.001);

        Assert.Equal(middle, field.Mean(0, 10), 1e-5);
        Assert.Equal(end, field.Mean(0, 20), 1e-5);
    }

    private static BoundaryElement Element(double length) => new(Pass(length), 0, 0, ElementForm.Free);

    private static FeaturePass Pass(double length) => new(0, 0, [0, length], []);

    internal static (Func<double, double> Truth, double[] Along, double[] Values) Curve(int seed, double noise)
    {
        var random = new Random(seed);
        var (length, count) = (Between(35, 45), random.Next(5, 15));
        var (shift, tilt) = (Between(-0.1, 0.1), Between(-0.05, 0.05));
        (double Amplitude, double Period, double Phase)[] waves = [
            .. Enumerable.Range(0, 2).Select(_ => (Between(0, 0.05), Between(25, 70), Between(0, 2 * Math.PI)))];
        double[] along = [.. Enumerable.Range(0, count).Select(i => length * i / (count - 1))];
        return (Truth, along, [.. along.Select(s => Truth(s) + (noise * Gauss()))]);

        double Truth(double s) => shift + (tilt * s / length)
            + waves.Sum(w => w.Amplitude * Math.Sin((2 * Math.PI * s / w.Period) + w.Phase));
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        double Gauss() => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }

    private static double Rms(Func<double, double> truth, Func<double, double> course, double length) => Math.Sqrt(
        Enumerable.Range(0, 201).Select(i => length * i / 200).Average(s => Math.Pow(course(s) - truth(s), 2)));

    private static double At95(List<double> values) => values.Order().ElementAt((int)(0.95 * values.Count));

    private static double Median(List<double> values) => values.Order().ElementAt(values.Count / 2);
}
