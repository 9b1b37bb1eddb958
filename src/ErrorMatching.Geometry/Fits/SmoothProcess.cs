namespace ErrorMatching.Geometry;

/// <summary>A Gaussian process through points with noise: an unknown constant plus a course with the covariance <c>(ratio sigma)^2
/// exp(-d^2 / (2 length^2))</c> of two places at the distance d, where sigma is the standard deviation of the noise of one point.</summary>
/// <remarks>
/// <para>
/// The constant has a flat prior (C. E. Rasmussen and C. K. I. Williams, "Gaussian Processes for Machine Learning", 2006, equations 2.41
/// to 2.43). The square of sigma has a scaled inverse chi-square prior about the stated uncertainty with <see cref="Known"/> degrees of
/// freedom, or the prior 1/sigma^2 if none is stated, and is integrated out in closed form (J. O. Berger, V. De Oliveira and B. Sanso,
/// "Objective Bayesian analysis of spatially correlated data", J. Am. Stat. Assoc. 96, 2001).
/// </para>
/// <para>
/// With <c>C = ratio^2 K + diag(1 / count)</c>, w = C^-1 1 and the n - 1 remaining degrees of freedom, the logarithm of the evidence is
/// <c>-(log|C| + log(1'w) + (n - 1 + known) log(S + known u^2)) / 2</c>, where S is the sum of squares of the ordinates less the constant,
/// weighted by C^-1.
/// </para>
/// </remarks>
internal sealed class SmoothProcess
{
    /// <summary>Degrees of freedom of a stated uncertainty: it is good to about a fifth. Larger scatter overrules it.</summary>
    private const double Known = 10;

    /// <summary>A sum of squares that has a logarithm, for groups whose means are all the same.</summary>
    private const double Nothing = 1e-300;

    private readonly double[] _places;
    private readonly double _length;
    private readonly double _squaredRatio;
    private readonly Cholesky _factor;
    private readonly double[] _ones;
    private readonly double[] _rest;
    private readonly double _sumOfOnes;
    private readonly double _constant;
    private readonly double _variance;

    /// <summary>Conditions the process on points.</summary>
    /// <param name="places">Abscissae.</param>
    /// <param name="values">Ordinates, each the mean of as many measured ones as its count.</param>
    /// <param name="counts">The number of measured points that each one is the mean of.</param>
    /// <param name="length">The length, in the unit of the abscissae.</param>
    /// <param name="ratio">Standard deviation of the course over that of the noise.</param>
    /// <param name="uncertainty">Stated standard uncertainty of a measured ordinate; 0 if it is not known.</param>
    public SmoothProcess(double[] places, double[] values, double[] counts, double length, double ratio, double uncertainty)
    {
        (_places, _length, _squaredRatio) = (places, length, ratio * ratio);
        // The noise on the diagonal keeps the pivots positive.
        _factor = Cholesky.Factor(CovarianceOf(counts), places.Length)!;
        _ones = Array.ConvertAll(places, _ => 1.0);
        _rest = [.. values];
        _factor.Forward(_ones);
        _factor.Forward(_rest);
        _sumOfOnes = Dot(_ones, _ones);
        _constant = Dot(_ones, _rest) / _sumOfOnes;
        for (var i = 0; i < _rest.Length; i++)
        {
            _rest[i] -= _constant * _ones[i];
        }

        var known = uncertainty > 0 ? Known : 0;
        var (sum, freedom) = (Math.Max(Dot(_rest, _rest) + (known * uncertainty * uncertainty), Nothing), places.Length - 1 + known);
        var logDeterminant = 2 * places.Select((_, i) => Elementary.Log(_factor.Pivot(i))).Sum();
        LogEvidence = -(logDeterminant + Elementary.Log(_sumOfOnes) + (freedom * Elementary.Log(sum))) / 2;
        _variance = sum / Math.Max(1, freedom - 2);
    }

    /// <summary>Logarithm of the probability density of the ordinates, up to a constant.</summary>
    public double LogEvidence { get; }

    /// <summary>The expected course at places, and the mean of its variance over them.</summary>
    public (double[] Course, double MeanVariance) At(double[] places)
    {
        var course = new double[places.Length];
        var covariances = new double[_places.Length];
        var sum = 0.0;
        for (var j = 0; j < places.Length; j++)
        {
            for (var i = 0; i < covariances.Length; i++)
            {
                covariances[i] = Covariance(_places[i] - places[j]);
            }

            _factor.Forward(covariances);
            course[j] = _constant + Dot(covariances, _rest);
            var missing = 1 - Dot(covariances, _ones);
            sum += _squaredRatio - Dot(covariances, covariances) + (missing * missing / _sumOfOnes);
        }

        return (course, _variance * sum / places.Length);
    }

    /// <summary>The covariance of the ordinates row by row, up to the diagonal.</summary>
    private double[] CovarianceOf(double[] counts)
    {
        var n = _places.Length;
        var matrix = new double[n * n];
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j <= i; j++)
            {
                matrix[(i * n) + j] = Covariance(_places[i] - _places[j]) + (i == j ? 1 / counts[i] : 0);
            }
        }

        return matrix;
    }

    private static double Dot(double[] a, double[] b)
    {
        var sum = 0.0;
        for (var i = 0; i < a.Length; i++)
        {
            sum += a[i] * b[i];
        }

        return sum;
    }

    private double Covariance(double distance) => _squaredRatio * Elementary.Exp(-distance * distance / (2 * _length * _length));
}
