using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>What may have moved the boundary of a part, and how likely each is after the key points were measured: a growth of the whole
/// outline, as by tool wear; a shift; a shift and a turn; or the shape of each feature by itself.</summary>
/// <remarks>Each cause is a Gaussian process over the boundary, with the same scale for all that it moves. Its evidence says how likely it
/// is (Rasmussen and Williams 2006, section 5.2): where one number explains all points, a shape of its own for each feature explains no
/// more and could have explained much else, so it is less likely. What is expected of a way of cutting is the mean over all causes; a way
/// that follows each point copies the noise, and this mean tells by how much.</remarks>
internal sealed class Causes
{
    // What the words of a program and the increments of an offset say at most, mm: a gauge without noise is not better than that.
    private const double LeastUncertaintyMm = 0.0003;

    // Causes are told apart by no more points than these, evenly taken; more say the same, and their cost grows with the cube.
    private const int MostPoints = 120;

    private readonly IReadOnlyList<ComparedPlace> _places;
    private readonly List<Cause> _causes = [];

    /// <summary>Compares the causes.</summary>
    /// <param name="places">The places, the key points among them.</param>
    /// <param name="wayMm">How far the boundary should move at each, toward the tool, mm.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a key point.</param>
    public Causes(IReadOnlyList<ComparedPlace> places, IReadOnlyList<double> wayMm, double uncertaintyMm)
    {
        _places = places;
        int[] points = [
            .. Enumerable.Range(0, places.Count).Where(k => places[k].Point >= 0).DistinctBy(k => (places[k].Feature, places[k].Point))];
        if (points.Length > MostPoints)
        {
            points = [.. Enumerable.Range(0, MostPoints).Select(i => points[(int)((long)i * (points.Length - 1) / (MostPoints - 1))])];
        }

        var noise = Math.Max(uncertaintyMm, LeastUncertaintyMm);
        var scale = Math.Max(Math.Sqrt(points.Average(k => wayMm[k] * wayMm[k])), noise);
        var middle = new Point2(points.Average(k => places[k].Place.X), points.Average(k => places[k].Place.Y));
        var size = Math.Max(Math.Sqrt(points.Average(k => Square((places[k].Place - middle).Length))), 1e-9);
        double[] turns = [.. places.Select(p => p.Normal.Dot((p.Place - middle).Left) / size)];
        var priors = places.Select(p => p.Run).Distinct().ToDictionary(
            r => r, r => r.Priors.Select(p => p.WithVague(scale)).ToArray());

        Add((_, _) => 1);
        Add((a, b) => places[a].Normal.Dot(places[b].Normal));
        Add((a, b) => places[a].Normal.Dot(places[b].Normal) + (turns[a] * turns[b]));
        Add(OfShape);
        var best = _causes.Max(c => c.Evidence);
        var sum = _causes.Sum(c => Elementary.Exp(c.Evidence - best));
        _causes = [.. _causes.Select(c => c with { Probability = Elementary.Exp(c.Evidence - best) / sum })];

        void Add(Func<int, int, double> covariance) =>
            _causes.Add(Cause.Of(points, places.Count, wayMm, noise, (a, b) => scale * scale * covariance(a, b)));

        // Of a feature without a course: its own shift and growth. Of a point that says nothing of its elements: its own deviation. In
        // parts of the scale's square.
        double OfShape(int a, int b)
        {
            var (one, other) = (places[a], places[b]);
            return !ReferenceEquals(one.Run, other.Run) ? 0
                : one.Run.Run.Elements.Count == 0 ? 1 + one.Normal.Dot(other.Normal)
                : one.Terms.Count == 0 ? (a == b ? 1 : 0)
                : DeviationField.Covariance(priors[one.Run], one.Terms, other.Terms) / (scale * scale);
        }
    }

    /// <summary>What is expected of a way of cutting.</summary>
    /// <param name="wayMm">How far it moves the boundary at each place, toward the tool, mm.</param>
    public ExpectedError Of(IReadOnlyList<double> wayMm)
    {
        var (rms, largest) = (0.0, 0.0);
        foreach (var cause in _causes)
        {
            double[] squares = [.. wayMm.Select((w, k) => Square(w - cause.Mean[k]) + cause.Variance[k])];
            rms += cause.Probability * MeanOf(squares);
            largest += cause.Probability * squares.Max();
        }

        return new(Math.Sqrt(rms), Math.Sqrt(largest));
    }

    // Each feature counts as much, however many places it has.
    private double MeanOf(double[] squares) =>
        Enumerable.Range(0, squares.Length).GroupBy(k => _places[k].Feature).Average(f => f.Average(k => squares[k]));

    private static double Square(double value) => value * value;

    // What a cause says of each place once the points are known.
    private sealed record Cause(double Evidence, double[] Mean, double[] Variance)
    {
        public double Probability { get; init; }

        public static Cause Of(int[] points, int places, IReadOnlyList<double> values, double noise, Func<int, int, double> covariance)
        {
            var n = points.Length;
            var all = new double[n * n];
            for (var i = 0; i < n; i++)
            {
                for (var j = 0; j <= i; j++)
                {
                    all[(i * n) + j] = covariance(points[i], points[j]) + (i == j ? noise * noise : 0);
                }
            }

            var factor = Cholesky.Factor(all, n)!;
            double[] measured = [.. points.Select(k => values[k])];
            double[] weights = [.. measured];
            factor.Solve(weights);
            var (mean, variance) = (new double[places], new double[places]);
            for (var k = 0; k < places; k++)
            {
                double[] with = [.. points.Select(p => covariance(k, p))];
                mean[k] = with.Zip(weights, (w, weight) => w * weight).Sum();
                variance[k] = Math.Max(0, covariance(k, k) - factor.Form(with));
            }

            return new(ErrorMatching.Mating.Evidence.Log(factor, measured), mean, variance);
        }
    }
}

/// <summary>The error that is expected of a way of cutting, mm: what it leaves, and how well that is known.</summary>
/// <param name="RmsMm">Root mean square over the boundary of the features.</param>
/// <param name="LargestMm">At the worst place.</param>
public sealed record ExpectedError(double RmsMm, double LargestMm);
