using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A quantity along a pass as a function of its length: a few coefficients through the values at the key points.</summary>
internal sealed class ArcLengthField
{
    /// <summary>How many times its largest value a course may go: smooth deviations were seen to reach 1.4 one point's distance behind the
    /// last point, those that follow scatter 17.</summary>
    private const double Calm = 2;

    /// <summary>At so many places it is looked at: a polynomial of degree 10 turns at most 9 times.</summary>
    private const int Looks = 200;

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
        new(
            PolynomialFit.Fit(along, values, new() { Degree = 1, Ridge = 0, PointUncertaintyMm = uncertaintyMm }),
            0,
            0,
            double.PositiveInfinity);

    /// <summary>
    /// A smooth course; degree and ridge as given, or chosen by the leave-one-out error.
    /// Beyond its first and last point it goes on straight for one mean distance of the points and stays there, since a polynomial says
    /// nothing outside its data. A degree that was chosen makes way for a lower one where the course goes further than <see cref="Calm"/>
    /// times its largest value: then it follows the scatter of its points and swings between and behind them,
    /// which the errors at the points do not show.
    /// </summary>
    public static ArcLengthField Smooth(
        IReadOnlyList<double> along, IReadOnlyList<double> values, int? degree, double? ridge, double uncertaintyMm)
    {
        var options = new PolynomialFitOptions { Degree = degree, Ridge = ridge, PointUncertaintyMm = uncertaintyMm };
        var (from, to) = (along.Min(), along.Max());
        var (reach, largest) = ((to - from) / (along.Count - 1), values.Max(Math.Abs));
        while (true)
        {
            var field = new ArcLengthField(PolynomialFit.Fit(along, values, options), from, to, reach);
            if (degree is not null || field.Fit.Degree <= 1 || field.Largest() <= Calm * largest)
            {
                return field;
            }

            options = options with { MaxDegree = field.Fit.Degree - 1 };
        }
    }

    private double Largest() =>
        Enumerable.Range(0, Looks + 1).Max(i => Math.Abs(At(_first - _reach + ((_last - _first + (2 * _reach)) * i / Looks))));

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
