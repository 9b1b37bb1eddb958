using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Whether values on a grid have a structure or are noise: Moran's I, and several tests with one error rate.</summary>
/// <remarks>The verdict is that of <see cref="Tests"/>, which look for alike or opposite neighbors, a plane, a quadratic and waves.
/// Moran's I alone takes waves of two or three points for noise.
/// I = n / W * sum w_ij z_i z_j / sum z_i^2, with z the values minus their mean. Neighbors have weight 1: the next points on the same
/// curve and, on the previous and next curves, the point nearest in u (the relation is made symmetric). All other weights are zero.
/// Expectation and variance are those under randomization (A. D. Cliff and J. K. Ord, Spatial Processes: Models and Applications, 1981,
/// section 2.3), taken over all permutations of the values among the places. The trend of a systematic error counts as structure. Noise
/// about a fitted field is judged by its residuals, whose I is slightly below the expectation because a fit absorbs part of what
/// neighbors share.</remarks>
/// <param name="I">Moran's I: about 0 for noise, towards 1 for smooth fields, below 0 if neighbors alternate.</param>
/// <param name="Expectation">-1 / (n - 1).</param>
/// <param name="Variance">Variance of I under randomization.</param>
/// <param name="Z">(I - expectation) / standard deviation.</param>
/// <param name="P">Probability that chance alone gives an I at least as far from its expectation, by the normal distribution.</param>
/// <param name="Verdict">The conclusion of all tests at the 5 % level.</param>
public sealed record SpatialStructure(double I, double Expectation, double Variance, double Z, double P, SpatialVerdict Verdict)
{
    /// <summary>The probability up to which a structure is taken for one.</summary>
    public const double Level = 0.05;

    /// <summary>Minimum number of points for the normal distribution to be meaningful.</summary>
    public const int LeastPoints = 10;

    // With 999 permutations, probabilities are stated to a thousandth. Of many points, fewer permutations show all that matters.
    private const int Permutations = 999;
    private const int FewPermutations = 199;
    private const int Many = 300;

    /// <summary>What each test found; empty if there are too few values, or in a document that is older than the tests.</summary>
    public IReadOnlyList<StructureTest> Tests { get; init; } = [];

    /// <summary>The tests that found a structure, the surest first.</summary>
    public IReadOnlyList<StructureTest> Found => [.. Tests.Where(t => t.P <= Level).OrderBy(t => t.P)];

    /// <summary>Tests measured errors.</summary>
    /// <param name="samples">Errors on the curves of a grid. Of fewer than 30, one more test asks whether they scatter more about their
    /// mean than the stated uncertainty explains, and all share the error rate with it (Bonferroni).</param>
    /// <param name="uncertaintyMm">Stated standard uncertainty of one of them; zero if unknown.</param>
    public static SpatialStructure Test(IReadOnlyList<ErrorSample> samples, double uncertaintyMm = 0)
    {
        ArgumentNullException.ThrowIfNull(samples);
        double[] errors = [.. samples.Select(s => s.ErrorMm)];
        var structure = Test(samples, errors);
        if (structure.Tests.Count == 0 || samples.Count >= FewPoints.Enough || !(uncertaintyMm > 0))
        {
            return structure;
        }

        var mean = errors.Average();
        var scatter = FewPoints.ProbabilityOfNoise(Array.ConvertAll(errors, e => e - mean), 1, uncertaintyMm);
        StructureTest[] tests = [
            .. structure.Tests.Append(new(StructureKind.Scatter, scatter)).Select(t => t with { P = Math.Min(1, 2 * t.P) })];
        return structure with
        {
            Tests = tests,
            Verdict = Array.Exists(tests, t => t.P <= Level) ? SpatialVerdict.Systematic : SpatialVerdict.Noise,
        };
    }

    /// <summary>Tests the residuals of a field. Systematic residuals mean that the field misses something.</summary>
    /// <param name="samples">The samples to which the field was fitted.</param>
    /// <param name="values">One value per sample, such as <see cref="FittedField.Residuals"/>, in the same order.</param>
    /// <exception cref="ArgumentException">The counts differ.</exception>
    public static SpatialStructure Test(IReadOnlyList<ErrorSample> samples, IReadOnlyList<double> values)
    {
        ArgumentNullException.ThrowIfNull(samples);
        ArgumentNullException.ThrowIfNull(values);
        if (samples.Count != values.Count)
        {
            throw new ArgumentException($"{values.Count} values for {samples.Count} samples", nameof(values));
        }

        var data = FieldData.Of(samples).With([.. values]);
        var moran = Test(data.Z, Neighbors(data));
        if (double.IsNaN(moran.I) || samples.Count < LeastPoints)
        {
            return moran;
        }

        var (mmU, mmV) = (LengthMm(samples, s => s.J, s => s.U), LengthMm(samples, s => s.I, s => s.V));
        StructureTest[] tests = [
            .. PermutationTest.Run(data, samples.Count > Many ? FewPermutations : Permutations)
                .Select(t => t with { WaveMm = (mmU / t.Waves.U, mmV / t.Waves.V) })];
        return moran with
        {
            Tests = tests,
            Verdict = Array.Exists(tests, t => t.P <= Level) ? SpatialVerdict.Systematic : SpatialVerdict.Noise,
        };
    }

    /// <summary>Length of the longest line of one direction from its first to its last point.</summary>
    private static double LengthMm(IReadOnlyList<ErrorSample> samples, Func<ErrorSample, int> line, Func<ErrorSample, double> along) =>
        samples.GroupBy(line)
            .Select(g => g.OrderBy(along).ToArray())
            .Max(l => l.Zip(l.Skip(1), (a, b) => (b.Nominal - a.Nominal).Length).Sum());

    /// <summary>Calculates Moran's I for symmetric neighbors of weight 1, without a verdict.</summary>
    internal static SpatialStructure Test(double[] values, IReadOnlyCollection<(int A, int B)> neighbors)
    {
        double n = values.Length;
        var expectation = -1 / (n - 1);
        var mean = values.Length > 0 ? values.Average() : 0;
        var z = Array.ConvertAll(values, v => v - mean);
        var m2 = z.Sum(x => x * x);
        if (values.Length < 4 || neighbors.Count == 0 || !(m2 > 0))
        {
            return new(double.NaN, expectation, double.NaN, double.NaN, double.NaN, SpatialVerdict.Undetermined);
        }

        var m4 = z.Sum(x => x * x * x * x);
        var degrees = new double[values.Length];
        var cross = 0.0;
        foreach (var (a, b) in neighbors)
        {
            cross += 2 * z[a] * z[b];
            degrees[a]++;
            degrees[b]++;
        }

        // Cliff and Ord: S0 is the sum of the weights, S1 half the sum of (w_ij + w_ji)^2, S2 the sum of the squared sums of rows and
        // columns; b2 is the kurtosis.
        var s0 = 2.0 * neighbors.Count;
        var s1 = 2 * s0;
        var s2 = degrees.Sum(d => 4 * d * d);
        var b2 = n * m4 / (m2 * m2);
        var i = n / s0 * cross / m2;
        var square = (
            (
                n * ((((n * n) - (3 * n) + 3) * s1) - (n * s2) + (3 * s0 * s0)))
                - (b2 * ((((n * n) - n) * s1) - (2 * n * s2) + (6 * s0 * s0)))) / ((n - 1) * (n - 2) * (n - 3) * s0 * s0);
        var variance = square - (expectation * expectation);
        var score = (i - expectation) / Math.Sqrt(variance);
        return new(i, expectation, variance, score, 2 * NormalTail(Math.Abs(score)), SpatialVerdict.Undetermined);
    }

    /// <summary>Pairs of neighbors, each once, the smaller index first.</summary>
    internal static HashSet<(int A, int B)> Neighbors(FieldData data)
    {
        var curves = data.Curves;
        var pairs = new HashSet<(int A, int B)>();
        for (var c = 0; c < curves.Length; c++)
        {
            for (var k = 0; k + 1 < curves[c].Length; k++)
            {
                Add(curves[c][k], curves[c][k + 1]);
            }

            if (c + 1 < curves.Length)
            {
                Across(curves[c], curves[c + 1]);
                Across(curves[c + 1], curves[c]);
            }
        }

        return pairs;

        void Add(int a, int b) => pairs.Add((Math.Min(a, b), Math.Max(a, b)));

        void Across(int[] from, int[] to)
        {
            foreach (var k in from)
            {
                Add(k, to.MinBy(other => Math.Abs(data.U[other] - data.U[k])));
            }
        }
    }

    /// <summary>Upper tail probability of the standard normal distribution: a series near zero, a continued fraction beyond 3 (Abramowitz
    /// and Stegun, Handbook of Mathematical Functions, 26.2.11 and 26.2.14).</summary>
    internal static double NormalTail(double x)
    {
        var density = Elementary.Exp(-0.5 * x * x) / Math.Sqrt(2 * Math.PI);
        if (Math.Abs(x) < 3)
        {
            var (term, sum) = (x, x);
            for (var k = 1; Math.Abs(term) > 1e-17 * Math.Abs(sum); k++)
            {
                term *= x * x / ((2 * k) + 1);
                sum += term;
            }

            return 0.5 - (density * sum);
        }

        var fraction = 0.0;
        for (var k = 200; k > 0; k--)
        {
            fraction = k / (Math.Abs(x) + fraction);
        }

        var tail = density / (Math.Abs(x) + fraction);
        return x > 0 ? tail : 1 - tail;
    }
}

/// <summary>Whether measured errors are systematic.</summary>
public enum SpatialVerdict
{
    /// <summary>The errors have a structure beyond chance: a systematic part, which mirroring can remove.</summary>
    Systematic,

    /// <summary>The errors have no more structure than chance gives: mirroring would cut noise into the surface.</summary>
    Noise,

    /// <summary>Too few points, or all errors are equal.</summary>
    Undetermined,
}
