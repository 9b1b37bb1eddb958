using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>What is known about the deviation of a stretch before it is measured: a Gaussian process over the length along the boundary.
/// Its covariance is the sum of a shift, a tilt, the change of an arc and a form error of some scales, or of the terms of a
/// polynomial.</summary>
/// <remarks>Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), sections 2.7 and 4.2.</remarks>
internal sealed class DeviationPrior
{
    /// <summary>Standard deviation of what the points alone determine, mm.</summary>
    public const double VagueMm = 1;

    private readonly Stretch _stretch;
    private double[] _deviations;

    // An array, because the sum over it is the innermost loop of an estimate.
    private readonly (double VarianceMm2, double LengthMm)[] _form = [];

    // The recurrence of the polynomials that are orthonormal over the key points (Forsythe 1957). A covariance has no use for the digits of
    // Geometry's basis in double-double, and is asked for too often to pay for them.
    private readonly (double Shift, double Before, double Norm)[] _terms;

    /// <summary>Creates the prior.</summary>
    /// <param name="stretch">The stretch.</param>
    /// <param name="tiltMm">Standard deviation of the tilt at both ends, and of the change of an arc.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point; scales the ridge of a polynomial.</param>
    /// <param name="places">The places of its own key points, for the terms of a polynomial.</param>
    public DeviationPrior(Stretch stretch, double tiltMm, double uncertaintyMm, IReadOnlyList<double> places)
    {
        _stretch = stretch;
        TiltMm = stretch.Form == ElementForm.Free ? null : tiltMm;
        _terms = stretch.Degree is { } degree ? TermsOf(places, Math.Min(degree, places.Count - 1)) : [];
        _deviations = stretch switch
        {
            { Form: ElementForm.Straight } => [VagueMm, tiltMm],
            { Form: ElementForm.Arc } => [VagueMm, tiltMm, tiltMm],
            { Degree: not null } => [.. _terms.Select((_, k) => OfTerm(k, stretch.Ridge, uncertaintyMm))],
            _ => [VagueMm, VagueMm],
        };
    }

    /// <summary>The form error: variances with their lengths of correlation, mm.</summary>
    public IReadOnlyList<(double VarianceMm2, double LengthMm)> Form
    {
        get => _form;
        init => _form = [.. value];
    }

    /// <summary>Standard deviation of the tilt at both ends, mm; null for a curve, whose linear mean is vague.</summary>
    public double? TiltMm { get; }

    /// <summary>What a report states of it.</summary>
    public ElementPrior Summary => new(
        TiltMm,
        Math.Sqrt(Form.Sum(f => f.VarianceMm2)),
        Form.Count == 0 ? null : Form.Sum(f => f.VarianceMm2 * f.LengthMm) / Form.Sum(f => f.VarianceMm2));

    /// <summary>The same prior where a scale is known of what the points alone determine here.</summary>
    /// <param name="mm">The standard deviation, mm.</param>
    public DeviationPrior WithVague(double mm)
    {
        var copy = (DeviationPrior)MemberwiseClone();

        // The terms of a polynomial have the mean square 1 / n over its n points.
        var ofTerm = _terms.Length == 0 ? mm : mm * _terms[0].Norm;
        copy._deviations = [.. _deviations.Select(d => d == VagueMm ? ofTerm : d)];
        return copy;
    }

    /// <summary>Covariance of the deviations at two places, mm^2.</summary>
    public double Covariance(double along, double other) => OfShape(along, other) + OfForm(along, other);

    /// <summary>The squared exponential: correlation of form errors at a distance.</summary>
    public static double Correlation(double distanceMm, double lengthMm) => Elementary.Exp(-Square(distanceMm / lengthMm) / 2);

    private double OfShape(double along, double other)
    {
        var (t, v) = (_stretch.Relative(along), _stretch.Relative(other));
        if (_stretch.Form == ElementForm.Arc)
        {
            var half = Math.Min(_stretch.Sweep, Math.PI) / 2;
            var (a, b) = (t * _stretch.Sweep / 2, v * _stretch.Sweep / 2);
            var (sine, bend) = (Elementary.Sin(half), 1 - Elementary.Cos(half));
            return Square(_deviations[0])
                + (Square(_deviations[1] / sine) * Elementary.Sin(a) * Elementary.Sin(b))
                + (Square(_deviations[2] / bend) * (1 - Elementary.Cos(a)) * (1 - Elementary.Cos(b)));
        }

        if (_terms.Length == 0)
        {
            return Square(_deviations[0]) + (Square(_deviations[1]) * t * v);
        }

        var sum = 0.0;
        foreach (var (k, at, atOther) in TermsAt(along, other))
        {
            sum += Square(_deviations[k]) * at * atOther;
        }

        return sum;
    }

    // p(k + 1) = (s - shift) p(k) - before p(k - 1), each divided by its norm.
    private IEnumerable<(int K, double At, double AtOther)> TermsAt(double along, double other)
    {
        var (p, q, pp, qq) = (1.0, 1.0, 0.0, 0.0);
        for (var k = 0; k < _terms.Length; k++)
        {
            yield return (k, p / _terms[k].Norm, q / _terms[k].Norm);
            (p, pp) = (((along - _terms[k].Shift) * p) - (_terms[k].Before * pp), p);
            (q, qq) = (((other - _terms[k].Shift) * q) - (_terms[k].Before * qq), q);
        }
    }

    private static (double Shift, double Before, double Norm)[] TermsOf(IReadOnlyList<double> places, int degree)
    {
        var terms = new List<(double, double, double)>();
        double[] p = [.. places.Select(_ => 1.0)], pp = [.. places.Select(_ => 0.0)];
        var before = 0.0;
        for (var k = 0; k <= degree; k++)
        {
            var square = p.Sum(Square);
            var shift = places.Zip(p, (s, value) => s * value * value).Sum() / square;
            terms.Add((shift, before, Math.Sqrt(square)));
            double[] next = [.. places.Select((s, i) => ((s - shift) * p[i]) - (before * pp[i]))];
            before = next.Sum(Square) / square;
            (pp, p) = (p, next);
        }

        return [.. terms];
    }

    private double OfForm(double along, double other)
    {
        var sum = 0.0;
        foreach (var (variance, length) in _form)
        {
            sum += variance * Correlation(along - other, length);
        }

        return sum;
    }

    // The ridge divides the coefficient of an orthonormal polynomial of degree k by 1 + weight k^4, as this variance does.
    private static double OfTerm(int k, double ridge, double uncertaintyMm) =>
        ridge == 0 || k == 0 ? VagueMm : uncertaintyMm / Math.Sqrt(ridge * Elementary.Pow(k, 4));

    private static double Square(double value) => value * value;
}
