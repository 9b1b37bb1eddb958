using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>Evaluates a surface at place after place along lines of constant v, several times as fast as one by one.</summary>
/// <remarks>
/// Over one span of u, a line is a polynomial whose coefficients about the middle of the span are kept until span or v change (the basis functions as polynomials: The NURBS Book, section 6.6); then a place costs two Horner schemes.
/// The result is that of <see cref="SplineSurface.At"/> but for rounding. It keeps what it evaluated last, so that each thread needs its own.
/// </remarks>
public sealed class SurfaceLine
{
    // Beyond this degree polynomials about a middle lose digits.
    private const int HighestDegree = 9;

    private readonly SplineSurface _surface;
    private readonly int _degree;

    // For each span of u the coefficients of its basis functions, once they were asked for: power by power, u less the middle of the span, in half spans.
    private readonly double[]?[] _powers;

    // The coefficients of the line and of its derivative by v.
    private readonly Vector256<double>[] _place;
    private readonly Vector256<double>[] _slope;
    private double _v = double.NaN;
    private int _span = -1;
    private double _middle;
    private double _perUnit;

    /// <summary>Lines of a surface.</summary>
    /// <param name="surface">The surface.</param>
    public SurfaceLine(SplineSurface surface)
    {
        ArgumentNullException.ThrowIfNull(surface);
        (_surface, _degree) = (surface, surface.KnotsU.Degree);
        _powers = new double[]?[surface.KnotsU.Values.Length];
        (_place, _slope) = (new Vector256<double>[_degree + 1], new Vector256<double>[_degree + 1]);
    }

    /// <summary>Position and derivatives at a pair of parameters. Lengths in millimetres.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="position">The point as a vector from the origin.</param>
    /// <param name="du">First derivative by u.</param>
    /// <param name="dv">First derivative by v.</param>
    public void At(double u, double v, out Vector3 position, out Vector3 du, out Vector3 dv)
    {
        if (_degree > HighestDegree)
        {
            var at = _surface.At(u, v);
            (position, du, dv) = (new(at.Position.X, at.Position.Y, at.Position.Z), at.Du, at.Dv);
            return;
        }

        Follow(u, v);
        var t = Vector256.Create((u - _middle) * _perUnit);
        var (s, su, sv) = (_place[_degree], Vector256<double>.Zero, _slope[_degree]);
        for (var k = _degree - 1; k >= 0; k--)
        {
            su = (su * t) + s;
            s = (s * t) + _place[k];
            sv = (sv * t) + _slope[k];
        }

        su *= _perUnit;
        if (_surface.IsRational)
        {
            // From the weighted surface to the surface (The NURBS Book, equation 4.20).
            var w = 1 / s[3];
            s *= w;
            su = (su - (s * su[3])) * w;
            sv = (sv - (s * sv[3])) * w;
        }

        (position, du, dv) = (Space(s), Space(su), Space(sv));
    }

    // The coefficients of the line at v over the span that holds u.
    private void Follow(double u, double v)
    {
        var knots = _surface.KnotsU;
        var values = knots.Values;
        var isInSpan = _span >= 0 && u >= values[_span] && u < values[_span + 1];
        if (isInSpan && v == _v)
        {
            return;
        }

        var span = isInSpan ? _span : knots.SpanAt(u);
        if (span != _span || v != _v)
        {
            var half = (values[span + 1] - values[span]) / 2;
            (_middle, _perUnit) = (values[span] + half, 1 / half);
            var powers = _powers[span] ??= Powers(span, half);
            _surface.AlongV(span, v, powers, _place, _slope);
            (_span, _v) = (span, v);
        }
    }

    private double[] Powers(int span, double half)
    {
        var width = _degree + 1;
        var powers = new double[width * width];
        _surface.KnotsU.Basis(span, _middle, _degree, powers);
        var factor = 1.0;
        for (var k = 1; k <= _degree; k++)
        {
            factor *= half / k;
            for (var i = 0; i < width; i++)
            {
                powers[(k * width) + i] *= factor;
            }
        }

        return powers;
    }

    private static Vector3 Space(Vector256<double> v) => new(v[0], v[1], v[2]);
}
