using System.Globalization;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Geometry;

/// <summary>A polynomial y(x) fitted to measured points by least squares, plain or regularized, of a given degree or of the degree whose
/// error over the whole curve is expected to be the least. Immutable.</summary>
/// <remarks>
/// <para>
/// The fit uses double-double arithmetic and polynomials that are orthogonal over the points (Forsythe 1957), with the abscissa mapped to
/// [-1, 1]. The coefficients in powers of x are rounded only once, at the end.
/// For decimals read by <see cref="DoubleDouble.Parse"/>, it keeps at least 14 digits on all certified polynomial data sets of NIST. The
/// result is identical for any order of the points.
/// </para>
/// <para>
/// Ridge: with the basis q orthonormal over the given points, the fit minimizes the sum of squared residuals plus <c>weight * sum(k^4
/// c[k]^2)</c>. The constant is never penalized, high degrees most.
/// The hat matrix remains diagonal in that basis, and leave-one-out errors follow from its diagonal if the penalty is not changed when a
/// point is left out.
/// </para>
/// </remarks>
public sealed class PolynomialFit
{
    private readonly double[] _a;
    private readonly double[] _b;
    private readonly double[] _terms;
    private readonly double[] _termErrors;
    private readonly double _center;
    private readonly double _halfWidth;
    private readonly Matrix<double> _basisInPowersOfT;

    private PolynomialFit(ForsytheBasis basis, LeaveOneOut leaveOneOut, int degree, double ridge, int[] places, double pointUncertaintyMm)
    {
        (Degree, Ridge) = (degree, ridge);
        (_center, _halfWidth) = (basis.Center, basis.HalfWidth);
        _a = [.. basis.A.Take(degree + 1).Select(v => v.ToDouble())];
        _b = [.. basis.B.Take(degree + 1).Select(v => v.ToDouble())];
        var kept = new DoubleDouble[degree + 1];
        var shrunk = new DoubleDouble[degree + 1];
        for (var k = 0; k <= degree; k++)
        {
            kept[k] = LeaveOneOut.Shrink(k, ridge);
            shrunk[k] = kept[k] * basis.Coefficients[k];
            EffectiveDegreesOfFreedom += kept[k].ToDouble();
        }

        _terms = [.. shrunk.Select(v => v.ToDouble())];
        var sum = DoubleDouble.Zero;
        var residuals = new double[places.Length];
        for (var i = 0; i < residuals.Length; i++)
        {
            var residual = basis.Residuals[degree][i];
            for (var k = 1; ridge > 0 && k <= degree; k++)
            {
                residual += (basis.Coefficients[k] - shrunk[k]) * basis.Values[k][i];
            }

            residuals[places[i]] = residual.ToDouble();
            sum += residual * residual;
        }

        Residuals = Array.AsReadOnly(residuals);
        var left = residuals.Length - EffectiveDegreesOfFreedom;
        var deviation = left > 0 ? DoubleDouble.Sqrt(sum / left) : DoubleDouble.Zero;
        ResidualStandardDeviation = deviation.ToDouble();
        LeaveOneOutRms = leaveOneOut.Rms(degree, ridge);
        var sigma = ResidualStandardDeviation >= pointUncertaintyMm ? deviation : pointUncertaintyMm;

        var powers = basis.InPowersOfX(degree);
        var coefficients = new DoubleDouble[degree + 1];
        var variances = new DoubleDouble[degree + 1];
        for (var k = 0; k <= degree; k++)
        {
            var variance = kept[k] * kept[k] / basis.SquaredNorms[k];
            for (var j = 0; j <= k; j++)
            {
                coefficients[j] += shrunk[k] * powers[k][j];
                variances[j] += variance * powers[k][j] * powers[k][j];
            }
        }

        Coefficients = Array.AsReadOnly([.. coefficients.Select(v => v.ToDouble())]);
        StandardErrors = Array.AsReadOnly([.. variances.Select(v => (sigma * DoubleDouble.Sqrt(v)).ToDouble())]);
        _termErrors = [.. basis.SquaredNorms.Take(degree + 1).Select((norm, k) => (sigma * kept[k] / DoubleDouble.Sqrt(norm)).ToDouble())];
        var inT = basis.InPowersOfT(degree);
        _basisInPowersOfT = Matrix<double>.Build.Dense(
            degree + 1, degree + 1, (k, j) => j <= k ? (inT[k][j] / DoubleDouble.Sqrt(basis.SquaredNorms[k])).ToDouble() : 0);
    }

    /// <summary>The degree, given or selected.</summary>
    public int Degree { get; }

    /// <summary>The ridge weight, given or selected; zero is plain least squares.</summary>
    public double Ridge { get; }

    /// <summary>The <c>Degree + 1</c> coefficients in ascending powers of the original x.</summary>
    public IReadOnlyList<double> Coefficients { get; }

    /// <summary>Standard errors of <see cref="Coefficients"/>, from the full covariance. They do not include the bias of a ridge.</summary>
    public IReadOnlyList<double> StandardErrors { get; }

    /// <summary>Measured minus fitted ordinates, in the given order.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Trace of the hat matrix: the number of coefficients, reduced by the ridge.</summary>
    public double EffectiveDegreesOfFreedom { get; }

    /// <summary>Root of the sum of squared residuals divided by n minus <see cref="EffectiveDegreesOfFreedom"/>; 0 if this is 0.</summary>
    public double ResidualStandardDeviation { get; }

    /// <summary>Root mean square error of predicting each point from the others; null if a point determines its own value, as with as many
    /// coefficients as points.</summary>
    public double? LeaveOneOutRms { get; }

    /// <summary>Condition number (2-norm) of the design matrix in powers of the abscissa mapped to [-1, 1]: how well the abscissae
    /// distinguish the coefficients, independent of unit and origin.</summary>
    public double Condition => Degree == 0 ? 1 : _basisInPowersOfT.ConditionNumber();

    /// <summary>The value at a place, from the orthogonal basis. It is exact to rounding where powers of x would lose digits.</summary>
    public double Evaluate(double x)
    {
        var (sum, _) = Recur(x, _terms);
        return sum;
    }

    /// <summary>The derivative dy/dx at a place.</summary>
    public double Derivative(double x)
    {
        var (_, slope) = Recur(x, _terms);
        return slope / _halfWidth;
    }

    /// <summary>Standard error of the fitted value at a place. It does not include the bias of a ridge.</summary>
    public double StandardErrorAt(double x)
    {
        var t = (x - _center) / _halfWidth;
        var (before, value, sum) = (0.0, 1.0, 0.0);
        for (var k = 0; k <= Degree; k++)
        {
            sum += _termErrors[k] * value * (_termErrors[k] * value);
            (before, value) = (value, ((t - _a[k]) * value) - (_b[k] * before));
        }

        return Math.Sqrt(sum);
    }

    /// <summary>The fit in powers of x. <see cref="Evaluate"/> is more accurate far from the origin.</summary>
    public Polynomial ToPolynomial() => new([.. Coefficients]);

    private (double Sum, double SlopeInT) Recur(double x, double[] weights)
    {
        var t = (x - _center) / _halfWidth;
        var (before, value, sum) = (0.0, 1.0, 0.0);
        var (slopeBefore, slope, slopeSum) = (0.0, 0.0, 0.0);
        for (var k = 0; k < weights.Length; k++)
        {
            sum += weights[k] * value;
            slopeSum += weights[k] * slope;
            var nextSlope = value + ((t - _a[k]) * slope) - (_b[k] * slopeBefore);
            (slopeBefore, slope) = (slope, nextSlope);
            (before, value) = (value, ((t - _a[k]) * value) - (_b[k] * before));
        }

        return (sum, slopeSum);
    }

    // The fitting.

    /// <summary>Fits a polynomial to points given as doubles.</summary>
    /// <param name="x">Abscissae.</param>
    /// <param name="y">Ordinates, in the same number.</param>
    /// <param name="options">Degree, ridge and stated uncertainty; null selects the degree and does not regularize.</param>
    /// <exception cref="GeometryException">As for the overload with double-doubles.</exception>
    /// <exception cref="ArgumentException">Abscissae and ordinates differ in number.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A degree, ridge weight or uncertainty is negative or not finite.</exception>
    public static PolynomialFit Fit(IReadOnlyList<double> x, IReadOnlyList<double> y, PolynomialFitOptions? options = null) =>
        Fit([.. x.Select(v => (DoubleDouble)v)], [.. y.Select(v => (DoubleDouble)v)], options);

    /// <summary>Fits a polynomial to points whose decimals are kept in double-double.</summary>
    /// <param name="x">Abscissae in any order; repetitions are allowed.</param>
    /// <param name="y">Ordinates, in the same number.</param>
    /// <param name="options">Degree, ridge and stated uncertainty; null selects the degree and does not regularize.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/> if there are fewer points than coefficients (or none);
    /// <see cref="GeometryError.CoincidentPoints"/> if all points coincide and more than a constant is requested;
    /// <see cref="GeometryError.RankDeficient"/> if there are fewer distinct abscissae than coefficients;
    /// <see cref="GeometryError.NotFinite"/>.</exception>
    /// <exception cref="ArgumentException">Abscissae and ordinates differ in number.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A degree, ridge weight or uncertainty is negative or not finite.</exception>
    public static PolynomialFit Fit(IReadOnlyList<DoubleDouble> x, IReadOnlyList<DoubleDouble> y, PolynomialFitOptions? options = null)
    {
        options ??= new();
        Check(options);
        Check(x, y, (options.Degree ?? 0) + 1);

        // Sorted, so that sums do not depend on the order of the points.
        int[] places = [.. Enumerable.Range(0, x.Count).OrderBy(i => x[i]).ThenBy(i => y[i])];
        DoubleDouble[] sortedX = [.. places.Select(i => x[i])];
        DoubleDouble[] sortedY = [.. places.Select(i => y[i])];
        var distinct = 1 + Enumerable.Range(1, sortedX.Length - 1).Count(i => sortedX[i] != sortedX[i - 1]);
        if (options.Degree >= distinct)
        {
            throw TooFewPlaces(options.Degree.Value, distinct, sortedY[0] == sortedY[^1] && distinct == 1);
        }

        var lowest = options.Degree ?? 0;
        var highest = options.Degree ?? Math.Min(options.MaxDegree, distinct - 1);
        var basis = ForsytheBasis.Build(sortedX, sortedY, highest);
        var leaveOneOut = new LeaveOneOut(basis);
        var (degree, ridge) = (options.Degree, options.Ridge) switch
        {
            ({ } fixedDegree, { } fixedRidge) => (fixedDegree, fixedRidge),
            (null, { } fixedRidge) => (
                DegreeChoice.Select(sortedX, sortedY, basis, fixedRidge, options.PointUncertaintyMm), fixedRidge),
            _ => leaveOneOut.Choose(
                Enumerable.Range(lowest, highest - lowest + 1), LeaveOneOut.Grid(), sortedY.Max(v => Math.Abs(v.ToDouble()))),
        };
        return new(basis, leaveOneOut, degree, ridge, places, options.PointUncertaintyMm);
    }

    private static void Check(PolynomialFitOptions options)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(options.Degree ?? 0, nameof(options));
        ArgumentOutOfRangeException.ThrowIfNegative(options.MaxDegree, nameof(options));
        if (options.Ridge is { } ridge && !(ridge >= 0 && double.IsFinite(ridge)))
        {
            throw new ArgumentOutOfRangeException(nameof(options), ridge, "A ridge weight is zero or more.");
        }

        Samples.CheckUncertainty(options.PointUncertaintyMm);
    }

    private static void Check(IReadOnlyList<DoubleDouble> x, IReadOnlyList<DoubleDouble> y, int least)
    {
        if (x.Count != y.Count)
        {
            throw new ArgumentException(
                string.Create(CultureInfo.InvariantCulture, $"{x.Count} abscissae cannot go with {y.Count} ordinates."), nameof(y));
        }

        if (x.Count < least)
        {
            throw new GeometryException(
                GeometryError.TooFewPoints,
                string.Create(
                    CultureInfo.InvariantCulture, $"A polynomial of degree {least - 1} needs at least {least} points; {x.Count} given."));
        }

        for (var i = 0; i < x.Count; i++)
        {
            if (!x[i].IsFinite || !y[i].IsFinite)
            {
                throw new GeometryException(
                    GeometryError.NotFinite,
                    string.Create(
                        CultureInfo.InvariantCulture, $"Point {i + 1} of {x.Count} has a coordinate that is not a finite number."));
            }
        }
    }

    private static GeometryException TooFewPlaces(int degree, int distinct, bool coincident) => coincident
        ? new(GeometryError.CoincidentPoints, "All points of the polynomial lie on one another.")
        : new(
            GeometryError.RankDeficient,
            string.Create(
                CultureInfo.InvariantCulture,
                $"A polynomial of degree {degree} needs {degree + 1} different abscissae; the points have {distinct}."));
}
