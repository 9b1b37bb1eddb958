using ErrorMatching.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Mating;

/// <summary>Finds the key points of one run that do not fit the others: each is predicted from the others, and named if it is further
/// off than they allow.</summary>
internal static class SuspectSearch
{
    /// <summary>Fewest points of a run that can contradict each other.</summary>
    public const int Fewest = 5;

    // Beside a bad point its neighbors look bad, too: the worst few are tried.
    private const int Tried = 3;

    // What the noise may be, in stated uncertainties, and the difference of evidence that says little.
    private static readonly double[] Noises = [1, 2, 4, 8];
    private const double NearlyAsWell = 0.5;

    // The largest risk that a good feature has a false name.
    private const double FalseNames = 0.01;

    // Nothing beyond an end contradicts it: a cut may bend there in truth, as that of the paper's curve does.
    private const double OfEnd = 2.0 / 3;

    // A direction that the points do not determine.
    private const double LeastShare = 1e-6;

    /// <summary>How many standard deviations a point may be off: few points know their own scales less well. With them, at most 1 of
    /// 100 random parts with smooth errors has a false name, where the stated uncertainty is right (<c>SuspectSearchTests</c>).</summary>
    private static double MostSigmas(int points) => points switch { <= 5 => 6, 6 => 5, _ => 4.3 };

    /// <summary>Searches the points of a run that has stretches with a course.</summary>
    /// <remarks>With the covariance K of all values, point i is off by r = [K^-1 y]_i / [K^-1]_ii with the standard deviation
    /// s = [K^-1]_ii^-1/2 (Rasmussen and Williams 2006, section 5.4.2; method, section 11). The scales of K are learned without the
    /// point, because a bad point widens them until it fits.</remarks>
    /// <param name="stretches">The stretches of the run.</param>
    /// <param name="rows">What its key points say.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a row.</param>
    public static IReadOnlyList<Suspect> AlongCourse(
        IReadOnlyList<Stretch> stretches, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm) =>
        All(rows.Count, left => WorstAlongCourse(stretches, [.. left.Select(i => rows[i])], uncertaintyMm), MostSigmas);

    /// <summary>Searches the points around a feature without a course, such as a bore: what they have in common is a shift, a turn and a
    /// growth.</summary>
    /// <remarks>Deleted residuals of least squares (Cook and Weisberg 1982, section 2.2). A point must be off by too much for the stated
    /// uncertainty, and for the scatter of the others too, which a bore that is not round has: that follows Student's distribution, and is
    /// told as the normal deviate of the same probability (Wallace 1959, Annals of Mathematical Statistics 30, equation 2).</remarks>
    /// <param name="points">The key points.</param>
    /// <param name="values">Their deviations along the normal.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a deviation.</param>
    public static IReadOnlyList<Suspect> AroundShape(IReadOnlyList<RunPoint> points, IReadOnlyList<double> values, double uncertaintyMm) =>
        All(points.Count, left => WorstAroundShape(
            [.. left.Select(i => points[i])],
            [.. left.Select(i => values[i])],
            Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm)), n => NormalDistribution.Quantile(1 - (FalseNames / 2 / n)));

    // If more than a fifth of the points do not fit, the model is wrong, not the points.
    private static List<Suspect> All(int count, Func<IReadOnlyList<int>, Suspect?> worst, Func<int, double> most)
    {
        var found = new List<Suspect>();
        List<int> left = [.. Enumerable.Range(0, count)];
        while (left.Count >= Fewest && worst(left) is { } next && next.Judged >= most(left.Count))
        {
            found.Add(next with { Row = left[next.Row] });
            left.RemoveAt(next.Row);
            if (5 * found.Count > count)
            {
                return [];
            }
        }

        return found;
    }

    private static Suspect? WorstAlongCourse(IReadOnlyList<Stretch> stretches, BoundaryRow[] rows, double uncertaintyMm)
    {
        var all = LeftOut(PriorChoice.Of(stretches, rows, uncertaintyMm).OfPiece, rows, uncertaintyMm);
        return Enumerable.Range(0, rows.Length).OrderByDescending(i => Math.Abs(all[i].Off / all[i].Sigma)).Take(Tried).Select(i =>
        {
            var (off, sigma) = WithoutIt(stretches, rows, i, uncertaintyMm);
            return new Suspect(i, off, off / sigma) { Share = IsEnd(stretches, rows, i) ? OfEnd : 1 };
        }).MaxBy(s => s.Judged);
    }

    // The stated uncertainty may be too small: then all points scatter, and none is wrong. Of the noises that explain the others nearly as
    // well as the best one, the one that allows the point the most counts.
    private static (double Off, double Sigma) WithoutIt(
        IReadOnlyList<Stretch> stretches, BoundaryRow[] rows, int row, double uncertaintyMm)
    {
        BoundaryRow[] others = [.. rows.Where((_, k) => k != row)];
        double[] values = [.. others.Select(r => r.ValueMm)];
        var tried = new List<(double Log, (double Off, double Sigma) Found)>();
        foreach (var factor in Noises)
        {
            var noise = factor * Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm);
            var priors = PriorChoice.Of(stretches, others, noise).OfPiece;
            tried.Add((Evidence.Log(DeviationField.CovarianceOf(priors, others, noise), values), LeftOut(priors, rows, noise)[row]));
        }

        var best = tried.Max(t => t.Log);
        return tried.Where(t => t.Log >= best - NearlyAsWell).Select(t => t.Found).MinBy(f => Math.Abs(f.Off / f.Sigma));
    }

    // The outermost point of a curve.
    private static bool IsEnd(IReadOnlyList<Stretch> stretches, BoundaryRow[] rows, int row)
    {
        if (rows[row].Terms is not [var own] || stretches[own.Stretch].Form != ElementForm.Free)
        {
            return false;
        }

        double[] places = [.. rows.SelectMany(r => r.Terms).Where(t => t.Stretch == own.Stretch).Select(t => t.AlongMm)];
        return own.AlongMm <= places.Min() || own.AlongMm >= places.Max();
    }

    private static (double Off, double Sigma)[] LeftOut(DeviationPrior[] priors, BoundaryRow[] rows, double uncertaintyMm)
    {
        var n = rows.Length;
        var factor = Cholesky.Factor(DeviationField.CovarianceOf(priors, rows, uncertaintyMm), n)!;
        var weights = new double[n];
        var own = new double[n];
        for (var k = 0; k < n; k++)
        {
            var column = new double[n];
            column[k] = 1;
            factor.Solve(column);
            own[k] = column[k];
            for (var i = 0; i < n; i++)
            {
                weights[i] += column[i] * rows[k].ValueMm;
            }
        }

        return [.. Enumerable.Range(0, n).Select(i => (weights[i] / own[i], 1 / Math.Sqrt(own[i])))];
    }

    private static Suspect? WorstAroundShape(RunPoint[] points, double[] values, double noise)
    {
        var n = points.Length;
        var middle = new Point2(points.Average(p => p.Theoretical.X), points.Average(p => p.Theoretical.Y));
        var size = points.Max(p => (p.Theoretical - middle).Length);
        var svd = Matrix<double>.Build.Dense(n, 4, (i, k) => k switch
        {
            0 => points[i].Normal.X,
            1 => points[i].Normal.Y,
            2 => (points[i].Theoretical - middle).Cross(points[i].Normal) / Math.Max(size, 1e-9),
            _ => 1,
        }).Svd();
        int[] told = [.. Enumerable.Range(0, Math.Min(4, n)).Where(k => svd.S[k] > LeastShare * svd.S[0])];

        // Two degrees of freedom tell the noise without the point.
        var free = n - told.Length - 1;
        if (free < 2)
        {
            return null;
        }

        var y = Vector<double>.Build.Dense(values);
        var fitted = told.Aggregate(Vector<double>.Build.Dense(n), (sum, k) => sum + (svd.U.Column(k) * svd.U.Column(k).DotProduct(y)));
        var left = y - fitted;
        var squares = left.DotProduct(left);
        return Enumerable.Range(0, n).Select(i =>
        {
            var own = 1 - told.Sum(k => svd.U[i, k] * svd.U[i, k]);
            if (own < LeastShare)
            {
                return new Suspect(i, 0, 0);
            }

            var others = Math.Sqrt(Math.Max(0, squares - (left[i] * left[i] / own)) / free);
            var alone = left[i] / Math.Sqrt(own);
            return new Suspect(i, left[i] / own, Math.Sign(alone) * Math.Min(Math.Abs(alone) / noise, NormalOf(alone / others, free)));
        }).MaxBy(s => s.Judged);
    }

    // The normal deviate of the same probability as a value of Student's distribution.
    private static double NormalOf(double t, int free) =>
        ((8.0 * free) + 1) / ((8.0 * free) + 3) * Math.Sqrt(free * Elementary.Log(1 + Math.Min(t * t / free, double.MaxValue)));

    /// <summary>A point that may not fit.</summary>
    /// <param name="Row">Its index.</param>
    /// <param name="OffMm">How far it is off what the others say.</param>
    /// <param name="Sigmas">The same in standard deviations.</param>
    internal sealed record Suspect(int Row, double OffMm, double Sigmas)
    {
        /// <summary>How much of the standard deviations counts.</summary>
        public double Share { get; init; } = 1;

        /// <summary>The standard deviations that count.</summary>
        public double Judged => Share * Math.Abs(Sigmas);
    }
}
