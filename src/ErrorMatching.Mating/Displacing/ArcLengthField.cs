using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A quantity along a pass as a function of its length: a few coefficients through the values at the key points.</summary>
internal sealed class ArcLengthField
{
    private readonly PolynomialFit _fit;
    private readonly double _first;
    private readonly double _last;
    private readonly double _reach;

    private ArcLengthField(PolynomialFit fit, double first, double last, double reach)
    {
        _fit = fit;
        _first = first;
        _last = last;
        _reach = reach;
    }

    /// <summary>The fit behind the field.</summary>
    public PolynomialFit Fit => _fit;

    /// <summary>A straight course: shift and tilt of a line. It holds beyond its points as well.</summary>
    public static ArcLengthField Straight(IReadOnlyList<double> along, IReadOnlyList<double> values, double uncertaintyMm) =>
        new(PolynomialFit.Fit(along, values, new() { Degree = 1, Ridge = 0, PointUncertaintyMm = uncertaintyMm }), 0, 0, double.PositiveInfinity);

    /// <summary>
    /// A smooth course; degree and ridge as given, or chosen by the leave-one-out error. Beyond its first and last point it goes on straight for one mean
    /// distance of the points and stays there, since a polynomial says nothing outside its data.
    /// </summary>
    public static ArcLengthField Smooth(IReadOnlyList<double> along, IReadOnlyList<double> values, int? degree, double? ridge, double uncertaintyMm)
    {
        var (from, to) = (along.Min(), along.Max());
        return new(
            PolynomialFit.Fit(along, values, new() { Degree = degree, Ridge = ridge, PointUncertaintyMm = uncertaintyMm }), from, to, (to - from) / (along.Count - 1));
    }

    /// <summary>The value at a length.</summary>
    public double At(double along)
    {
        if (double.IsPositiveInfinity(_reach))
        {
            return _fit.Evaluate(along);
        }

        var inside = Math.Clamp(along, _first, _last);
        return _fit.Evaluate(inside) + (_fit.Derivative(inside) * Math.Clamp(along - inside, -_reach, _reach));
    }

    /// <summary>Standard error of the value at a length inside the points.</summary>
    public double StandardErrorAt(double along) => _fit.StandardErrorAt(along);
}
