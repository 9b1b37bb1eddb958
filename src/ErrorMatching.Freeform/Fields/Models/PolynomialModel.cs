namespace ErrorMatching.Freeform;

/// <summary>A sum of few terms, some of them one-sided behind a break.</summary>
internal sealed class PolynomialModel : FieldModel
{
    private readonly Term[] _terms;
    private readonly LeastSquares _fit;

    private PolynomialModel(FieldData data, Term[] terms, LeastSquares fit)
        : base(data)
    {
        (_terms, _fit) = (terms, fit);
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

    /// <summary>The corrected information criterion.</summary>
    public double Criterion { get; }

    /// <summary>True if nothing but rounding is left.</summary>
    public bool IsExact => SquareSum <= Data.Count * TermSelection.Rounding(Data.Z);

    public override double Freedom => _terms.Length;

    public override double Noise => Math.Sqrt(_fit.SquareSum / Math.Max(1, Data.Count - _terms.Length - BreaksU.Count - BreaksV.Count));

    /// <summary>The fit of given terms; null if the values do not determine them.</summary>
    public static PolynomialModel? Fit(FieldData data, Term[] terms) =>
        LeastSquares.Solve([.. terms.Select(t => t.Over(data.U, data.V))], data.Z) is { } fit ? new(data, terms, fit) : null;

    /// <summary>The fit of the terms that <see cref="TermSelection"/> chooses.</summary>
    public static PolynomialModel Choose(FieldData data, IReadOnlyList<double> breaksU, IReadOnlyList<double> breaksV, int degree = TermSelection.HighestDegree) =>
        Fit(data, TermSelection.Of(data, breaksU, breaksV, degree).Terms)!;

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
    /// <remarks>The breaks move again: kept, they would tell of the values that are left out.</remarks>
    public override FieldModel? Refit(FieldData other) => Fit(other, _terms) is { } model ? BreakRefinement.Run(model) : null;

    private static double[] Breaks(IEnumerable<AxisFunction> functions) => [.. functions.Where(f => f.Break is not null).Select(f => f.Break!.Value).Distinct().Order()];
}
