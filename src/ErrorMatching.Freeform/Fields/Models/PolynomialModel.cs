namespace ErrorMatching.Freeform;

/// <summary>A sparse polynomial, some of whose terms may be one-sided beyond a break.</summary>
internal sealed class PolynomialModel : FieldModel
{
    private readonly Term[] _terms;
    private readonly LeastSquares _fit;
    private readonly bool _isFree;

    /// <param name="data">The values.</param>
    /// <param name="terms">The terms.</param>
    /// <param name="fit">Their fit.</param>
    /// <param name="isFree">True if the terms were selected without breaks; they are then reselected for other values.</param>
    private PolynomialModel(FieldData data, Term[] terms, LeastSquares fit, bool isFree = false)
        : base(data)
    {
        (_terms, _fit, _isFree) = (terms, fit, isFree);
        BreaksU = Breaks(terms.Select(t => t.U));
        BreaksV = Breaks(terms.Select(t => t.V));
        Criterion = TermSelection.CriterionOf(data, fit.SquareSum, terms.Length, BreaksU.Count + BreaksV.Count);
    }

    public override FieldModelKind Kind => FieldModelKind.Polynomial;

    public override IReadOnlyList<double> BreaksU { get; }

    public override IReadOnlyList<double> BreaksV { get; }

    public override int DegreeU => Math.Max(1, _terms.Max(t => t.U.Power));

    public override int DegreeV => Math.Max(1, _terms.Max(t => t.V.Power));

    public IReadOnlyList<Term> Terms => _terms;

    public IReadOnlyList<double> Coefficients => _fit.Coefficients;

    public double SquareSum => _fit.SquareSum;

    public double MeanResidual => _fit.Residuals.Average(Math.Abs);

    /// <summary>The corrected Akaike information criterion.</summary>
    public double Criterion { get; }

    /// <summary>True if only rounding errors remain.</summary>
    public bool IsExact => SquareSum <= Data.Count * TermSelection.Rounding(Data.Z);

    public override double Freedom => _terms.Length;

    public override double Noise => Math.Sqrt(_fit.SquareSum / Math.Max(1, Data.Count - _terms.Length - BreaksU.Count - BreaksV.Count));

    /// <summary>Fits given terms; null if the values do not determine them.</summary>
    public static PolynomialModel? Fit(FieldData data, Term[] terms) =>
        LeastSquares.Solve(Term.Over(terms, data.U, data.V), data.Z) is { } fit ? new(data, terms, fit) : null;

    /// <summary>Fits the terms that <see cref="TermSelection"/> selects.</summary>
    public static PolynomialModel Choose(
        FieldData data, IReadOnlyList<double> breaksU, IReadOnlyList<double> breaksV, int degree = TermSelection.HighestDegree)
    {
        var model = Fit(data, TermSelection.Select(data, breaksU, breaksV, degree).Terms)!;
        return breaksU.Count + breaksV.Count == 0 && degree == TermSelection.HighestDegree
            ? new(data, model._terms, model._fit, isFree: true)
            : model;
    }

    public override double At(double u, double v)
    {
        var sum = 0.0;
        for (var k = 0; k < _terms.Length; k++)
        {
            sum += _fit.Coefficients[k] * _terms[k].At(u, v);
        }

        return sum;
    }

    public override double VarianceAt(double u, double v, double noise)
    {
        Span<double> row = stackalloc double[_terms.Length];
        for (var k = 0; k < row.Length; k++)
        {
            row[k] = _terms[k].At(u, v);
        }

        return noise * noise * _fit.Leverage(row);
    }

    /// <inheritdoc/>
    /// <remarks>Terms selected without breaks are reselected. Otherwise they would carry information about the left-out values, and the
    /// polynomial would seem better than it is. Breaks are moved for the same reason. A few lines locate them, and all lines refine
    /// them.</remarks>
    public override FieldModel? Refit(FieldData other)
    {
        if (_isFree)
        {
            return Choose(other, [], []);
        }

        var few = other.Thinned(FieldData.EnoughLines);
        var moved = Fit(few, _terms) is { } start ? BreakRefinement.Run(start) : null;
        return few == other || moved is null ? moved : Fit(other, moved._terms);
    }

    private static double[] Breaks(IEnumerable<AxisFunction> functions) =>
        [.. functions.Where(f => f.Break is not null).Select(f => f.Break!.Value).Distinct().Order()];
}
