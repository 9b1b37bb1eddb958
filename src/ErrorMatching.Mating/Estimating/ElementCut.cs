using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The displacement that the cut of an element follows: the field of a free element, else the line or circle nearest to
/// it.</summary>
internal sealed class ElementCut
{
    // Places and weights of Gauss and Legendre's rule with six nodes.
    private static readonly (double Place, double Weight)[] _nodes =
    [
        (-0.932469514203152, 0.171324492379170),
        (-0.661209386466265, 0.360761573048139),
        (-0.238619186083197, 0.467913934572691),
        (0.238619186083197, 0.467913934572691),
        (0.661209386466265, 0.360761573048139),
        (0.932469514203152, 0.171324492379170),
    ];

    private readonly Func<double, double> _at;

    private ElementCut(Func<double, double> at) => _at = at;

    /// <summary>An element that stays where it is.</summary>
    public static ElementCut Still { get; } = new(_ => 0);

    /// <summary>The displacement at a length along the boundary, toward the tool, mm.</summary>
    public double At(double along) => _at(along);

    /// <summary>The cut that follows a field.</summary>
    /// <param name="element">The element.</param>
    /// <param name="field">The deviation at a length along the boundary, mm.</param>
    public static ElementCut Following(BoundaryElement element, Func<double, double> field) => element.Form switch
    {
        ElementForm.Straight => Straight(element, field),
        ElementForm.Arc => Circle(element, field),
        ElementForm.Free => new(Once(field)),
        _ => throw new ArgumentOutOfRangeException(nameof(element), element.Form, "Unknown form."),
    };

    // The end of a motion is the start of the next one.
    private static Func<double, double> Once(Func<double, double> field)
    {
        var known = new Dictionary<double, double>();
        return along => known.TryGetValue(along, out var value) ? value : known[along] = field(along);
    }

    // The coefficients of the first two Legendre polynomials.
    private static ElementCut Straight(BoundaryElement element, Func<double, double> field)
    {
        var (shift, tilt) = (0.0, 0.0);
        foreach (var (place, weight) in _nodes)
        {
            var value = field(AlongOf(element, place));
            shift += weight * value / 2;
            tilt += 1.5 * weight * value * place;
        }

        return new(along => shift + (tilt * element.Relative(along)));
    }

    // Least squares of 1, sin and 1 - cos of the angle from the middle: a growth and a shift of the center.
    private static ElementCut Circle(BoundaryElement element, Func<double, double> field)
    {
        var (n, nb, bb, sa, sv, v, bv) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        foreach (var (place, weight) in _nodes)
        {
            var (value, angle) = (field(AlongOf(element, place)), place * element.Sweep / 2);
            var (sine, bend) = (Elementary.Sin(angle), 1 - Elementary.Cos(angle));
            n += weight;
            nb += weight * bend;
            bb += weight * bend * bend;
            sa += weight * sine * sine;
            sv += weight * sine * value;
            v += weight * value;
            bv += weight * bend * value;
        }

        var bending = ((n * bv) - (nb * v)) / ((n * bb) - (nb * nb));
        var (growth, across) = ((v - (bending * nb)) / n, sv / sa);
        return new(along =>
        {
            var angle = element.Relative(along) * element.Sweep / 2;
            return growth + (across * Elementary.Sin(angle)) + (bending * (1 - Elementary.Cos(angle)));
        });
    }

    private static double AlongOf(BoundaryElement element, double relative) =>
        (element.FromMm + element.ToMm + (relative * (element.ToMm - element.FromMm))) / 2;
}
