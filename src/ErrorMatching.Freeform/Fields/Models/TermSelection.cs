using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Selects the terms of a polynomial with given breaks. Forward selection takes the term that reduces the sum of squares most,
/// provided that its lower terms in both directions are present. The length with the lowest corrected criterion is kept.</summary>
/// <remarks>AICc = n ln(S / n) + 2 k + 2 k (k + 1) / (n - k - 1), with k the number of terms, breaks and the noise (Burnham and Anderson,
/// Model Selection and Multimodel Inference, 2nd edition, equation 2.4). A term is rejected if the fit would predict a place between
/// neighboring values with more than the variance of one measured value: the polynomial oscillates there.</remarks>
internal sealed class TermSelection
{
    public const int HighestDegree = 8;

    private const int MostTerms = 40;
    private const double MostAmplification = 1;

    private readonly FieldData _data;
    private readonly int _breaks;
    private readonly int _mostU;
    private readonly int _mostV;
    private readonly List<Candidate> _candidates;
    private readonly List<Candidate> _taken = [];
    private readonly HashSet<Term> _terms = [];
    private readonly HashSet<AxisFunction> _functionsU = [];
    private readonly HashSet<AxisFunction> _functionsV = [];
    private readonly double[] _rest;
    private readonly double[] _variance;

    private TermSelection(FieldData data, IReadOnlyList<double> breaksU, IReadOnlyList<double> breaksV, int degree)
    {
        _data = data;
        _breaks = breaksU.Count + breaksV.Count;
        _mostU = Most(data.Crossings.Length, breaksU.Count);
        _mostV = Most(data.Curves.Length, breaksV.Count);
        _rest = (double[])data.Z.Clone();
        var (betweenU, betweenV) = data.Between;
        _variance = new double[betweenU.Length];
        Term[] terms =
        [
            .. from a in AxisFunction.Hierarchy(Math.Min(degree, data.Crossings.Length - 1), breaksU)
               from b in AxisFunction.Hierarchy(Math.Min(degree, data.Curves.Length - 1), breaksV)
               where a.Power <= degree && b.Power <= degree && a.Power + b.Power <= HighestDegree
               select new Term(a, b),
        ];
        var (columns, between) = (Term.Over(terms, data.U, data.V), Term.Over(terms, betweenU, betweenV));
        _candidates = [.. terms.Select((term, k) => new Candidate(term, columns[k], between[k]))];
    }

    public Term[] Terms { get; private set; } = [];

    /// <summary>The criterion of the selected terms; infinite if there are too few values for any term.</summary>
    public double Criterion { get; private set; } = double.PositiveInfinity;

    public static TermSelection Select(FieldData data, IReadOnlyList<double> breaksU, IReadOnlyList<double> breaksV, int degree)
    {
        var selection = new TermSelection(data, breaksU, breaksV, degree);
        selection.Run();
        return selection;
    }

    public static double CriterionOf(FieldData data, double squareSum, int terms, int breaks)
    {
        var (n, k) = (data.Count, terms + breaks + 1);
        return n - k - 1 > 0
            ? (n * Elementary.Log((squareSum / n) + Rounding(data.Z))) + (2 * k) + (2.0 * k * (k + 1) / (n - k - 1))
            : double.PositiveInfinity;
    }

    /// <summary>The variance below which a residual means nothing: the square of 0.1 pm plus the rounding of large values.</summary>
    public static double Rounding(double[] values)
    {
        var largest = 0.0;
        foreach (var value in values)
        {
            largest = Math.Max(largest, Math.Abs(value));
        }

        var rounding = 1e-10 + (1e-14 * largest);
        return rounding * rounding;
    }

    /// <summary>Maximum number of functions on an axis. As many functions as lines would fit any values. With breaks, the number is
    /// reduced so that moving them cannot fit every line, including left-out ones. Three lines are trusted to show a square.</summary>
    private static int Most(int lines, int breaks) => breaks > 0 ? lines - 2 - breaks : Math.Max(lines - 1, Math.Min(lines, 3));

    private void Run()
    {
        Take(_candidates[0]);
        Terms = [_taken[0].Term];
        Criterion = CriterionOf(_data, LeastSquares.Product(_rest, _rest), 1, _breaks);
        while (_taken.Count < MostTerms && Next() is { } next)
        {
            Take(next);
            var criterion = CriterionOf(_data, LeastSquares.Product(_rest, _rest), _taken.Count, _breaks);
            if (criterion < Criterion)
            {
                (Criterion, Terms) = (criterion, [.. _taken.Select(c => c.Term)]);
            }
        }
    }

    private Candidate? Next()
    {
        while (true)
        {
            var (best, most) = ((Candidate?)null, -1.0);
            foreach (var candidate in _candidates)
            {
                if (!Allowed(candidate.Term))
                {
                    continue;
                }

                candidate.Follow(_taken, _rest);
                if (candidate.Norm > candidate.SquareNorm * LeastSquares.Dependent * LeastSquares.Dependent && candidate.Gain > most)
                {
                    (best, most) = (candidate, candidate.Gain);
                }
            }

            if (best is null || !Amplifies(best))
            {
                return best;
            }

            _candidates.Remove(best);
        }
    }

    private bool Allowed(Term term) =>
        Taken(term.U.Parent, term.V)
            && Taken(term.U, term.V.Parent)
            && (_functionsU.Count < _mostU || _functionsU.Contains(term.U))
            && (_functionsV.Count < _mostV || _functionsV.Contains(term.V));

    private bool Taken(AxisFunction? u, AxisFunction? v) => u is not { } a || v is not { } b || _terms.Contains(new Term(a, b));

    private bool Amplifies(Candidate candidate)
    {
        for (var k = 0; k < _variance.Length; k++)
        {
            if (_variance[k] + (candidate.Between[k] * candidate.Between[k] / candidate.Norm) > MostAmplification)
            {
                return true;
            }
        }

        return false;
    }

    private void Take(Candidate candidate)
    {
        candidate.Follow(_taken, _rest);
        foreach (var taken in _taken)
        {
            candidate.Remove(taken);
        }

        var norm = 1 / Math.Sqrt(LeastSquares.Product(candidate.Column, candidate.Column));
        LeastSquares.Scale(candidate.Column, norm);
        LeastSquares.Scale(candidate.Between, norm);
        _candidates.Remove(candidate);
        _taken.Add(candidate);
        _terms.Add(candidate.Term);
        _functionsU.Add(candidate.Term.U);
        _functionsV.Add(candidate.Term.V);
        LeastSquares.Remove(_rest, candidate.Column);
        LeastSquares.Remove(_rest, candidate.Column);
        for (var k = 0; k < _variance.Length; k++)
        {
            _variance[k] += candidate.Between[k] * candidate.Between[k];
        }
    }

    /// <summary>The values of a term, orthogonalized to the terms selected before when it is its turn.</summary>
    private sealed class Candidate(Term term, double[] column, double[] between)
    {
        private int _removed;
        private int _measured = -1;

        public Term Term => term;

        public double[] Column => column;

        public double[] Between => between;

        /// <summary>The squared length of the column as it was.</summary>
        public double SquareNorm { get; } = LeastSquares.Product(column, column);

        /// <summary>The squared length of what is left of the column.</summary>
        public double Norm { get; private set; }

        /// <summary>What the term would take of the sum of squares.</summary>
        public double Gain { get; private set; }

        /// <summary>Orthogonalizes it to the terms selected since it was last looked at.</summary>
        public void Follow(List<Candidate> taken, double[] rest)
        {
            for (; _removed < taken.Count; _removed++)
            {
                Remove(taken[_removed]);
            }

            if (_measured < _removed)
            {
                _measured = _removed;
                (Norm, var part) = Vectors.Dots(column, column, rest);
                Gain = part * part / Norm;
            }
        }

        public void Remove(Candidate unit)
        {
            Vectors.Subtract(Between, LeastSquares.Remove(Column, unit.Column), unit.Between);
        }
    }
}
