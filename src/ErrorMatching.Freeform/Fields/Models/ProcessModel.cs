using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A Gaussian process about a low-degree polynomial whose coefficients are estimated together with it (universal kriging;
/// Rasmussen and Williams, Gaussian Processes for Machine Learning, section 2.7).</summary>
/// <remarks>Unlike Geometry's process through the points of one curve, and Mating's along a boundary, it has two directions: on a grid, its
/// covariance is never a whole matrix, and is not factored but decomposed (<see cref="GridCovariance"/>).</remarks>
internal sealed class ProcessModel : FieldModel
{
    private readonly Kernel _kernel;
    private readonly Term[] _trend;
    private readonly ProcessTrend _polynomial;
    private readonly Covariance _covariance;
    private readonly double[][] _columns;
    private readonly double[][] _solved;
    private readonly BandedCholesky _factor;
    private readonly double[] _coefficients;
    private readonly double[] _weights;
    private readonly double _variance;
    private Basis? _basis;

    private ProcessModel(ProcessTrend trend, Kernel kernel, Covariance covariance, double[][] solved, BandedCholesky factor)
        : base(trend.Data)
    {
        (_kernel, _trend, _covariance, _columns, _solved, _factor) = (kernel, trend.Terms, covariance, trend.Columns, solved, factor);
        _polynomial = trend;
        // Subtract the polynomial first. The likelihood is not affected, and this preserves digits where the polynomial is large.
        var (data, columns, rest) = (trend.Data, trend.Columns, (double[])trend.Ordinary.Residuals.Clone());
        var correction = factor.Solve(Array.ConvertAll(solved, s => LeastSquares.Product(s, rest)));
        for (var k = 0; k < columns.Length; k++)
        {
            for (var i = 0; i < rest.Length; i++)
            {
                rest[i] -= correction[k] * columns[k][i];
            }
        }

        _coefficients = [.. trend.Ordinary.Coefficients.Zip(correction, (a, b) => a + b)];
        var solution = covariance.Solve(rest);
        _weights = covariance.ToBasis(solution);
        var form = Math.Max(LeastSquares.Product(solution, rest), 1e-26);
        var free = data.Count - _trend.Length;
        _variance = form / free;
        Criterion = (data.Count * Elementary.Log(form / data.Count)) + covariance.LogDeterminant + (2 * _trend.Length);
        Likelihood = -0.5 * ((free * Elementary.Log(_variance)) + covariance.LogDeterminant + factor.LogDeterminant);
    }

    public override FieldModelKind Kind => FieldModelKind.GaussianProcess;

    public override IReadOnlyList<double> BreaksU =>
        [.. _trend.Where(t => t.U.Break is not null).Select(t => t.U.Break!.Value).Distinct().Order()];

    public override IReadOnlyList<double> BreaksV =>
        [.. _trend.Where(t => t.V.Break is not null).Select(t => t.V.Break!.Value).Distinct().Order()];

    public override int DegreeU => 5;

    public override int DegreeV => 5;

    public override bool IsSpline => false;

    /// <summary>Logarithm of the restricted likelihood with the best variance, without constants (Rasmussen and Williams, equation
    /// 2.45).</summary>
    public double Likelihood { get; }

    /// <summary>Minus twice the logarithm of the full likelihood, without constants, plus twice the number of trend coefficients. Unlike
    /// <see cref="Likelihood"/>, it can compare trends.</summary>
    public double Criterion { get; }

    public Kernel Kernel => _kernel;

    /// <summary>Variance of the process where the kernel is one.</summary>
    public double Variance => _variance;

    public ProcessTrend Trend => _polynomial;

    public Covariance Covariance => _covariance;

    public override double Noise => Math.Sqrt(_variance * _kernel.Noise);

    public override double Freedom
    {
        get
        {
            var trend = _factor;
            var trace = _covariance.InverseTrace;
            for (var k = 0; k < _trend.Length; k++)
            {
                trace -= trend.Solve(Array.ConvertAll(_solved, s => LeastSquares.Product(s, _solved[k])))[k];
            }

            return Data.Count - (_kernel.Noise * trace);
        }
    }

    /// <summary>Fits the process with a given kernel; null if double precision is insufficient.</summary>
    public static ProcessModel? Fit(ProcessTrend? trend, Kernel kernel) =>
        trend is not null && Covariance.Of(trend.Data, kernel) is { } covariance ? Fit(trend, kernel, covariance, []) : null;

    /// <summary>Fits the process with a covariance that is shared with other trends.</summary>
    /// <param name="trend">The polynomial.</param>
    /// <param name="kernel">The kernel.</param>
    /// <param name="covariance">Its matrix.</param>
    /// <param name="begun">The matrix's solutions for the first columns of the polynomial, if they are shared with other trends.</param>
    public static ProcessModel? Fit(ProcessTrend? trend, Kernel kernel, Covariance covariance, double[][] begun)
    {
        if (trend is null)
        {
            return null;
        }

        var columns = trend.Columns;
        double[][] solved = [.. begun, .. columns.Skip(begun.Length).Select(covariance.Solve)];
        var rows = new double[columns.Length][];
        for (var i = 0; i < rows.Length; i++)
        {
            rows[i] = [.. Enumerable.Range(0, i + 1).Select(j => LeastSquares.Product(columns[i], solved[j]))];
        }

        return BandedCholesky.Factor(rows, rows.Length) is { } factor ? new(trend, kernel, covariance, solved, factor) : null;
    }

    public override double At(double u, double v)
    {
        var sum = _covariance.Sum(u, v, _weights);
        for (var k = 0; k < _trend.Length; k++)
        {
            sum += _coefficients[k] * _trend[k].At(u, v);
        }

        return sum;
    }

    /// <inheritdoc/>
    /// <remarks>In the basis of the covariance, a place takes little more than one look at each value: reports ask for thousands.</remarks>
    public override double VarianceAt(double u, double v, double noise)
    {
        var basis = _basis ??= Basis.Of(_covariance, _columns, _solved);
        var row = _covariance.RowInBasis(u, v);
        var solved = _covariance.SolveInBasis(row);
        var missed = new double[_trend.Length];
        for (var k = 0; k < missed.Length; k++)
        {
            missed[k] = _trend[k].At(u, v) - Vectors.Dot(solved, basis.Columns[k]);
        }

        var share = _factor.Solve(missed);
        var variance = _variance * Math.Max(0, _kernel.AtZero - LeastSquares.Product(row, solved) + LeastSquares.Product(missed, share));
        var more = (noise * noise) - (Noise * Noise);
        if (more <= 0)
        {
            return variance;
        }

        var square = 0.0;
        for (var k = 0; k < share.Length; k++)
        {
            Vectors.Subtract(solved, -share[k], basis.Solved[k]);
            square += share[k] * Vectors.Dot(share, basis.Others[k]);
        }

        return variance + (more * (square + LeastSquares.Product(solved, solved)));
    }

    /// <inheritdoc/>
    /// <remarks>A break is moved again. Otherwise it would carry information about the left-out values.</remarks>
    public override FieldModel? Refit(FieldData other)
    {
        if (other.Count <= _trend.Length || Covariance.Of(other, _kernel, _covariance) is not { } covariance)
        {
            return null;
        }

        return BreaksU.Count + BreaksV.Count == 0
            ? Fit(ProcessTrend.Of(other, _trend), _kernel, covariance, [])
            : ProcessSearch.WithBreakMoved(this, other, covariance);
    }

    /// <summary>The polynomial in the basis of the covariance, made when it is first needed.</summary>
    /// <param name="Columns">Its columns.</param>
    /// <param name="Solved">Their solutions.</param>
    /// <param name="Others">The products of the solutions' parts that are not leading.</param>
    private sealed record Basis(double[][] Columns, double[][] Solved, double[][] Others)
    {
        public static Basis Of(Covariance covariance, double[][] columns, double[][] solved)
        {
            var parts = Array.ConvertAll(solved, covariance.ToBasis);
            var rest = covariance.Leading..;
            return new(
                Array.ConvertAll(columns, covariance.ToBasis),
                parts,
                Array.ConvertAll(parts, a => Array.ConvertAll(parts, b => Vectors.Dot(a.AsSpan(rest), b.AsSpan(rest)))));
        }
    }
}
