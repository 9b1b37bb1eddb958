using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Geometry;

/// <summary>
/// A polynomial y(x) through measured points by least squares, plain or regularized, of a given degree or of the degree that predicts left-out points best. Immutable.
/// </summary>
/// <remarks>
/// <para>
/// The fit runs in double-double over polynomials that are orthogonal on the points themselves (Forsythe 1957), on the abscissa mapped to [-1, 1]; the coefficients
/// in powers of x are rounded once, at the end. Given decimals as they were read (<see cref="DoubleDouble.Parse"/>) it keeps 14 digits and more on all certified polynomial sets of NIST.
/// The order of the points does not matter, not even in the last bit.
/// </para>
/// <para>
/// Ridge: with the basis q orthonormal over the given points, the sum of squared residuals plus <c>weight * sum(k^4 c[k]^2)</c> is made least. The constant is never penalized,
/// high degrees most. The hat matrix stays diagonal in that basis, and leave-one-out errors follow from its diagonal, the penalty being kept as it is when a point is left out.
/// </para>
/// </remarks>
public sealed partial class PolynomialFit
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
        _basisInPowersOfT = Matrix<double>.Build.Dense(degree + 1, degree + 1, (k, j) => j <= k ? (inT[k][j] / DoubleDouble.Sqrt(basis.SquaredNorms[k])).ToDouble() : 0);
    }

    /// <summary>The degree, given or chosen.</summary>
    public int Degree { get; }

    /// <summary>The ridge weight, given or chosen; zero is plain least squares.</summary>
    public double Ridge { get; }

    /// <summary>The coefficients in ascending powers of x as given, <c>Degree + 1</c> of them.</summary>
    public IReadOnlyList<double> Coefficients { get; }

    /// <summary>Standard errors of <see cref="Coefficients"/>, from the full covariance. Under a ridge they do not include its bias.</summary>
    public IReadOnlyList<double> StandardErrors { get; }

    /// <summary>Measured less fitted ordinates, in the order of the points given.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Trace of the hat matrix: the number of coefficients, less what the ridge takes from them.</summary>
    public double EffectiveDegreesOfFreedom { get; }

    /// <summary>Root of the sum of squared residuals over n less <see cref="EffectiveDegreesOfFreedom"/>; zero where nothing is left over.</summary>
    public double ResidualStandardDeviation { get; }

    /// <summary>Root mean square by which the fit through the others misses each point; null where a point determines its own value, as with as many coefficients as points.</summary>
    public double? LeaveOneOutRms { get; }

    /// <summary>
    /// Condition number (2-norm) of the design in powers of the abscissa mapped to [-1, 1]: how well the places of the points tell the coefficients apart, whatever unit and origin.
    /// </summary>
    public double Condition => Degree == 0 ? 1 : _basisInPowersOfT.ConditionNumber();

    /// <summary>The value at a place, from the orthogonal basis: exact to rounding where the powers of x would lose digits.</summary>
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

    /// <summary>Standard error of the fitted value at a place. Under a ridge it does not include its bias.</summary>
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

    /// <summary>The fit in powers of x. <see cref="Evaluate"/> is more exact far from the origin.</summary>
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
}
