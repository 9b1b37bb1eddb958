using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The deviations of all stretches of a boundary, given the key points: the posterior of a Gaussian process.</summary>
/// <remarks>Rasmussen and Williams (2006), equations 2.25, 2.26 and 2.30. Unlike Geometry's process through the points of one curve, its
/// noise is stated, its rows are sums over several stretches, and what a stretch has in common is in its prior.</remarks>
internal sealed class DeviationField
{
    /// <summary>Smallest standard uncertainty that is calculated with, mm.</summary>
    public const double LeastUncertaintyMm = UncertaintyBudget.LeastMm;

    private readonly IReadOnlyList<DeviationPrior> _priors;
    private readonly IReadOnlyList<BoundaryRow> _rows;
    private readonly Cholesky? _factor;

    // For each stretch, the places where rows speak of it, with their weights in an estimate.
    private readonly List<(double AlongMm, double Weight)>[] _terms;

    public DeviationField(IReadOnlyList<DeviationPrior> priors, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm)
    {
        (_priors, _rows) = (priors, rows);
        _terms = [.. priors.Select(_ => new List<(double, double)>())];
        if (rows.Count == 0)
        {
            return;
        }

        // The noise on the diagonal keeps the covariance positive definite.
        _factor = Cholesky.Factor(CovarianceOf(priors, rows, uncertaintyMm), rows.Count)!;
        double[] weights = [.. rows.Select(r => r.ValueMm)];
        _factor.Solve(weights);
        for (var i = 0; i < rows.Count; i++)
        {
            foreach (var term in rows[i].Terms)
            {
                _terms[term.Stretch].Add((term.AlongMm, weights[i] * term.Weight));
            }
        }
    }

    /// <summary>The covariance of rows, row by row, with their noise.</summary>
    public static double[] CovarianceOf(IReadOnlyList<DeviationPrior> priors, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm)
    {
        // Many rows round off more.
        var n = rows.Count;
        var noise = Math.Max(uncertaintyMm, LeastUncertaintyMm * Math.Max(1, n / 100.0));
        var covariance = new double[n * n];
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j <= i; j++)
            {
                covariance[(i * n) + j] = covariance[(j * n) + i] =
                    Covariance(priors, rows[i].Terms, rows[j].Terms) + (i == j ? noise * noise : 0);
            }
        }

        return covariance;
    }

    /// <summary>The best estimate of the deviation at a place, mm.</summary>
    public double Mean(int stretch, double along)
    {
        var sum = 0.0;
        foreach (var (place, weight) in _terms[stretch])
        {
            sum += weight * _priors[stretch].Covariance(along, place);
        }

        return sum;
    }

    /// <summary>Standard deviation of the deviation at a place, mm.</summary>
    public double StandardDeviation(int stretch, double along)
    {
        var variance = _priors[stretch].Covariance(along, along);
        if (_factor is not null)
        {
            variance -= _factor.Form([.. Enumerable.Range(0, _rows.Count).Select(i => WithRow(stretch, along, i))]);
        }

        return Math.Sqrt(Math.Max(0, variance));
    }

    /// <summary>The best estimate of a weighted sum of deviations, mm.</summary>
    public double Mean(IReadOnlyList<RowTerm> terms) => terms.Sum(t => t.Weight * Mean(t.Stretch, t.AlongMm));

    /// <summary>What is known about weighted sums of deviations together.</summary>
    public JointDeviation Together(IReadOnlyList<IReadOnlyList<RowTerm>> places)
    {
        // The factor's inverse times the covariances with the rows.
        var explained = new double[places.Count][];
        for (var k = 0; k < explained.Length; k++)
        {
            explained[k] = [.. _rows.Select(r => Covariance(_priors, r.Terms, places[k]))];
            _factor?.Forward(explained[k]);
        }

        return new(_priors, places, explained);
    }

    private double WithRow(int stretch, double along, int row)
    {
        var sum = 0.0;
        foreach (var term in _rows[row].Terms)
        {
            sum += term.Stretch == stretch ? term.Weight * _priors[stretch].Covariance(along, term.AlongMm) : 0;
        }

        return sum;
    }

    /// <summary>The covariance of two weighted sums before anything is measured.</summary>
    internal static double Covariance(
        IReadOnlyList<DeviationPrior> priors, IReadOnlyList<RowTerm> terms, IReadOnlyList<RowTerm> others)
    {
        var sum = 0.0;
        foreach (var term in terms)
        {
            foreach (var other in others)
            {
                sum += term.Stretch == other.Stretch
                    ? term.Weight * other.Weight * priors[term.Stretch].Covariance(term.AlongMm, other.AlongMm)
                    : 0;
            }
        }

        return sum;
    }
}

/// <summary>What one key point says about the deviations of stretches: their weighted sum is the measured value.</summary>
/// <param name="Terms">One term for a point beside a stretch, two in the round of a corner.</param>
/// <param name="ValueMm">The measured value, from the counterpart's material to its tool.</param>
internal sealed record BoundaryRow(IReadOnlyList<RowTerm> Terms, double ValueMm);

/// <summary>A share of a row.</summary>
/// <param name="Stretch">Index of the stretch among those of its run.</param>
/// <param name="AlongMm">Place on it: length along the boundary.</param>
/// <param name="Weight">The weight.</param>
internal sealed record RowTerm(int Stretch, double AlongMm, double Weight);

/// <summary>The posterior covariance of deviations at several places of one field.</summary>
/// <remarks>Rasmussen and Williams (2006), equation 2.24: what was not known before, less what the key points explain.</remarks>
internal sealed class JointDeviation
{
    private readonly IReadOnlyList<DeviationPrior> _priors;
    private readonly IReadOnlyList<IReadOnlyList<RowTerm>> _places;
    private readonly double[][] _explained;

    /// <summary>Creates it.</summary>
    /// <param name="priors">The priors of the stretches.</param>
    /// <param name="places">The places.</param>
    /// <param name="explained">For each place, its covariances with the key points, divided by the factor of theirs.</param>
    public JointDeviation(IReadOnlyList<DeviationPrior> priors, IReadOnlyList<IReadOnlyList<RowTerm>> places, double[][] explained) =>
        (_priors, _places, _explained) = (priors, places, explained);

    /// <summary>Number of places.</summary>
    public int Count => _places.Count;

    /// <summary>The covariance of two places, mm^2.</summary>
    public double Covariance(int place, int other)
    {
        var sum = DeviationField.Covariance(_priors, _places[place], _places[other]);
        var (a, b) = (_explained[place], _explained[other]);
        for (var i = 0; i < a.Length; i++)
        {
            sum -= a[i] * b[i];
        }

        return sum;
    }
}

/// <summary>The joint uncertainty of some places of the boundary: a few columns, each scaled by one random number.</summary>
/// <param name="First">The first of the places.</param>
/// <param name="Columns">The columns, each with a number for each place, mm.</param>
internal sealed record JointFactor(int First, IReadOnlyList<double[]> Columns)
{
    // What remains of the variance at a place, as a part of the largest one: 3 % of a standard deviation.
    private const double Remains = 1e-3;

    /// <summary>The factor of a joint posterior: Cholesky's with the largest variance left as the pivot, until little is left. Smooth
    /// deviations at hundreds of places need about as many columns as there are key points.</summary>
    /// <param name="first">The first of the places.</param>
    /// <param name="joint">What is known about them.</param>
    public static JointFactor Factor(int first, JointDeviation joint)
    {
        var n = joint.Count;
        double[] left = [.. Enumerable.Range(0, n).Select(k => joint.Covariance(k, k))];
        var (columns, least) = (new List<double[]>(), Remains * left.DefaultIfEmpty().Max());
        while (columns.Count < n)
        {
            var pivot = 0;
            for (var k = 1; k < n; k++)
            {
                pivot = left[k] > left[pivot] ? k : pivot;
            }

            if (!(left[pivot] > least))
            {
                break;
            }

            var (column, root) = (new double[n], Math.Sqrt(left[pivot]));
            for (var k = 0; k < n; k++)
            {
                var sum = joint.Covariance(k, pivot);
                foreach (var before in columns)
                {
                    sum -= before[k] * before[pivot];
                }

                column[k] = sum / root;
                left[k] -= column[k] * column[k];
            }

            left[pivot] = 0;
            columns.Add(column);
        }

        return new(first, columns);
    }
}
