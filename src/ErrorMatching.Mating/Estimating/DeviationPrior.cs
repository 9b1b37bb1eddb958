namespace ErrorMatching.Mating;

/// <summary>What is known about the deviation of an element before it is measured: a Gaussian process over the length along the boundary.
/// Its covariance is the sum of a shift, a tilt, the change of an arc and a form error of some scales, or of the terms of a
/// polynomial.</summary>
/// <remarks>Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), sections 2.7 and 4.2.</remarks>
internal sealed class DeviationPrior
{
    /// <summary>Standard deviation of what the points alone determine, mm.</summary>
    public const double VagueMm = 1;

    private readonly BoundaryElement _element;
    private readonly double[] _deviations;

    /// <summary>Creates the prior.</summary>
    /// <param name="element">The element.</param>
    /// <param name="tiltMm">Standard deviation of the tilt at both ends, and of the change of an arc.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point; scales the ridge of a polynomial.</param>
    /// <param name="points">Number of points; scales the ridge too.</param>
    public DeviationPrior(BoundaryElement element, double tiltMm, double uncertaintyMm, int points)
    {
        _element = element;
        _deviations = element switch
        {
            { Form: ElementForm.Straight } => [VagueMm, tiltMm],
            { Form: ElementForm.Arc } => [VagueMm, tiltMm, tiltMm],
            { Degree: { } degree } => [.. Enumerable.Range(0, degree + 1).Select(k => OfTerm(k, element.Ridge, uncertaintyMm, points))],
            _ => [VagueMm, VagueMm],
        };
    }

    /// <summary>The form error: variances with their lengths of correlation, mm.</summary>
    public IReadOnlyList<(double VarianceMm2, double LengthMm)> Form { get; init; } = [];

    /// <summary>Covariance of the deviations at two places, mm^2.</summary>
    public double Covariance(double along, double other) => OfShape(along, other) + OfForm(along, other);

    /// <summary>The squared exponential: correlation of form errors at a distance.</summary>
    public static double Correlation(double distanceMm, double lengthMm) => Math.Exp(-Square(distanceMm / lengthMm) / 2);

    private double OfShape(double along, double other)
    {
        var (t, v) = (_element.Relative(along), _element.Relative(other));
        if (_element.Form == ElementForm.Arc)
        {
            var half = Math.Min(_element.Sweep, Math.PI) / 2;
            var (a, b) = (t * _element.Sweep / 2, v * _element.Sweep / 2);
            var (sine, bend) = (Math.Sin(half), 1 - Math.Cos(half));
            return Square(_deviations[0])
                + (Square(_deviations[1] / sine) * Math.Sin(a) * Math.Sin(b))
                + (Square(_deviations[2] / bend) * (1 - Math.Cos(a)) * (1 - Math.Cos(b)));
        }

        // Legendre polynomials.
        var sum = Square(_deviations[0]);
        var (p, q, pp, qq) = (t, v, 1.0, 1.0);
        for (var k = 1; k < _deviations.Length; k++)
        {
            sum += Square(_deviations[k]) * p * q;
            (p, pp) = ((((2 * k) + 1) * t * p / (k + 1)) - (k * pp / (k + 1)), p);
            (q, qq) = ((((2 * k) + 1) * v * q / (k + 1)) - (k * qq / (k + 1)), q);
        }

        return sum;
    }

    private double OfForm(double along, double other)
    {
        var sum = 0.0;
        foreach (var (variance, length) in Form)
        {
            sum += variance * Correlation(along - other, length);
        }

        return sum;
    }

    // The ridge divides the coefficient of an orthonormal polynomial of degree k by 1 + weight k^4, as this variance does.
    private static double OfTerm(int k, double ridge, double uncertaintyMm, int points) => ridge == 0 || k == 0
        ? VagueMm
        : Math.Min(VagueMm, uncertaintyMm * Math.Sqrt(((2 * k) + 1) / (points * ridge * Math.Pow(k, 4))));

    private static double Square(double value) => value * value;
}
