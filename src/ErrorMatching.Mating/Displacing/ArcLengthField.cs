using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A quantity as a function of the length along a pass: a few coefficients fitted to the values at the key points.</summary>
internal sealed class ArcLengthField
{
    /// <summary>Largest ratio of a curve to its largest value at a key point. One point spacing beyond the last point, smooth deviations
    /// reached 1.4 and those that follow scatter 17.</summary>
    private const double Calm = 2;

    /// <summary>Number of places that are checked; a polynomial of degree 10 has at most 9 turning points.</summary>
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

    /// <summary>A straight course: shift and tilt of a line. Valid beyond its points too.</summary>
    public static ArcLengthField Straight(IReadOnlyList<double> along, IReadOnlyList<double> values, double uncertaintyMm) =>
        new(
            PolynomialFit.Fit(along, values, new() { Degree = 1, Ridge = 0, PointUncertaintyMm = uncertaintyMm }),
            0,
            0,
            double.PositiveInfinity);

    /// <summary>A smooth course; degree and ridge as given, or chosen by the leave-one-out error. Beyond its first and last point it
    /// continues straight for one mean point spacing and then stays constant, because a polynomial says nothing outside its data. If the
    /// course exceeds <see cref="Calm"/> times its largest value, a chosen degree is lowered: the course then follows the scatter of its
    /// points and swings between and beyond them, which the errors at the points do not show.</summary>
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

    /// <summary>Standard error of the value at a length within the points.</summary>
    public double StandardErrorAt(double along) => _fit.StandardErrorAt(along);
}
