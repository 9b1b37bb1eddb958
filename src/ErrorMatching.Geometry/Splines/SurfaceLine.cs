using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>Evaluates a surface at successive places on lines of constant v, several times as fast as separately, and faster still four at
/// a time.</summary>
/// <remarks>Over one span of u, a line is a polynomial. Its coefficients about the middle of the span are cached until v changes (the basis
/// functions as polynomials: The NURBS Book, section 6.6), so that a place costs two Horner schemes. The result equals that of
/// <see cref="SplineSurface.At"/> except for rounding. Because of the cache, each thread needs its own instance.</remarks>
public sealed class SurfaceLine
{
    // At higher degrees, polynomials about a middle lose digits.
    private const int HighestDegree = 9;

    private readonly SplineSurface _surface;
    private readonly int _degree;
    private readonly Piece?[] _pieces;
    private Piece? _last;

    /// <summary>Prepares lines of a surface.</summary>
    /// <param name="surface">The surface.</param>
    public SurfaceLine(SplineSurface surface)
    {
        ArgumentNullException.ThrowIfNull(surface);
        (_surface, _degree) = (surface, surface.KnotsU.Degree);
        _pieces = new Piece?[surface.KnotsU.Values.Length];
    }

    /// <summary>Position and first derivatives at a pair of parameters. Lengths in millimeters.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="position">The point as a vector from the origin.</param>
    /// <param name="du">First derivative with respect to u.</param>
    /// <param name="dv">First derivative with respect to v.</param>
    public void At(double u, double v, out Vector3 position, out Vector3 du, out Vector3 dv)
    {
        if (_degree > HighestDegree)
        {
            var at = _surface.At(u, v);
            (position, du, dv) = (new(at.Position.X, at.Position.Y, at.Position.Z), at.Du, at.Dv);
            return;
        }

        var span = Follow(u, v);
        var (place, slope) = (span.Place, span.Slope);
        var t = Vector256.Create((u - span.Middle) * span.PerUnit);
        var (s, su, sv) = (place[^1], Vector256<double>.Zero, slope[^1]);
        for (var k = place.Length - 2; k >= 0; k--)
        {
            su = (su * t) + s;
            s = (s * t) + place[k];
            sv = (sv * t) + slope[k];
        }

        su *= span.PerUnit;
        if (_surface.IsRational)
        {
            // Converts the weighted surface to the surface (The NURBS Book, equation 4.20).
            var w = 1 / s[3];
            s *= w;
            su = (su - (s * su[3])) * w;
            sv = (sv - (s * sv[3])) * w;
        }

        (position, du, dv) = (Space(s), Space(su), Space(sv));
    }

    /// <summary>The same at four first parameters. Each result is identical to a single evaluation, to the last bit.</summary>
    /// <param name="u">Four first parameters; fastest if all are between the same two knots.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="position">The points as vectors from the origin.</param>
    /// <param name="du">First derivatives with respect to u.</param>
    /// <param name="dv">First derivatives with respect to v.</param>
    public void At(Vector256<double> u, double v, out FourVectors position, out FourVectors du, out FourVectors dv)
    {
        if (_degree > HighestDegree || !Follow(u[0], v).Holds(u))
        {
            At(u[0], v, out var p0, out var du0, out var dv0);
            At(u[1], v, out var p1, out var du1, out var dv1);
            At(u[2], v, out var p2, out var du2, out var dv2);
            At(u[3], v, out var p3, out var du3, out var dv3);
            (position, du, dv) = (FourVectors.Of(p0, p1, p2, p3), FourVectors.Of(du0, du1, du2, du3), FourVectors.Of(dv0, dv1, dv2, dv3));
            return;
        }

        // x, y, z, w of each coefficient.
        var span = Follow(u[0], v);
        var place = MemoryMarshal.Cast<Vector256<double>, double>(span.Place);
        var slope = MemoryMarshal.Cast<Vector256<double>, double>(span.Slope)[..place.Length];
        var t = (u - Vector256.Create(span.Middle)) * span.PerUnit;
        var i = place.Length - 4;
        var (x, y, z, w) = (
            Vector256.Create(place[i]), Vector256.Create(place[i + 1]), Vector256.Create(place[i + 2]), Vector256.Create(place[i + 3]));
        var (xv, yv, zv, wv) = (
            Vector256.Create(slope[i]), Vector256.Create(slope[i + 1]), Vector256.Create(slope[i + 2]), Vector256.Create(slope[i + 3]));
        var (xu, yu, zu, wu) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
        var isRational = _surface.IsRational;
        for (i -= 4; i >= 0; i -= 4)
        {
            (xu, yu, zu) = ((xu * t) + x, (yu * t) + y, (zu * t) + z);
            (x, y, z) = (
                (x * t) + Vector256.Create(place[i]), (y * t) + Vector256.Create(place[i + 1]), (z * t) + Vector256.Create(place[i + 2]));
            (xv, yv, zv) = (
                (xv * t) + Vector256.Create(slope[i]),
                (yv * t) + Vector256.Create(slope[i + 1]),
                (zv * t) + Vector256.Create(slope[i + 2]));
            if (isRational)
            {
                wu = (wu * t) + w;
                w = (w * t) + Vector256.Create(place[i + 3]);
                wv = (wv * t) + Vector256.Create(slope[i + 3]);
            }
        }

        (xu, yu, zu, wu) = (xu * span.PerUnit, yu * span.PerUnit, zu * span.PerUnit, wu * span.PerUnit);
        (position, du, dv) = (new(x, y, z), new(xu, yu, zu), new(xv, yv, zv));
        if (isRational)
        {
            var share = Vector256<double>.One / w;
            position *= share;
            du = (du - (position * wu)) * share;
            dv = (dv - (position * wv)) * share;
        }
    }

    /// <summary>Position and the derivatives that determine how it, its tangents and its normal change along the line. Lengths in
    /// millimeters.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="position">The point as a vector from the origin.</param>
    /// <param name="du">First derivative with respect to u.</param>
    /// <param name="dv">First derivative with respect to v.</param>
    /// <param name="duu">Second derivative with respect to u.</param>
    /// <param name="duv">Mixed second derivative.</param>
    public void At(double u, double v, out Vector3 position, out Vector3 du, out Vector3 dv, out Vector3 duu, out Vector3 duv)
    {
        if (_degree > HighestDegree)
        {
            var at = _surface.At(u, v);
            (position, du, dv, duu, duv) = (new(at.Position.X, at.Position.Y, at.Position.Z), at.Du, at.Dv, at.Duu, at.Duv);
            return;
        }

        var span = Follow(u, v);
        var (place, slope) = (span.Place, span.Slope);
        var t = Vector256.Create((u - span.Middle) * span.PerUnit);
        var (s, su, sv) = (place[^1], Vector256<double>.Zero, slope[^1]);
        var (suu, suv) = (Vector256<double>.Zero, Vector256<double>.Zero);
        for (var k = place.Length - 2; k >= 0; k--)
        {
            suu = (suu * t) + su;
            su = (su * t) + s;
            s = (s * t) + place[k];
            suv = (suv * t) + sv;
            sv = (sv * t) + slope[k];
        }

        su *= span.PerUnit;
        suv *= span.PerUnit;
        suu *= 2 * span.PerUnit * span.PerUnit;
        if (_surface.IsRational)
        {
            var (w, wu, wv, wuu, wuv) = (1 / s[3], su[3], sv[3], suu[3], suv[3]);
            s *= w;
            su = (su - (s * wu)) * w;
            sv = (sv - (s * wv)) * w;
            suu = (suu - (su * (2 * wu)) - (s * wuu)) * w;
            suv = (suv - (su * wv) - (sv * wu) - (s * wuv)) * w;
        }

        (position, du, dv, duu, duv) = (Space(s), Space(su), Space(sv), Space(suu), Space(suv));
    }

    // The line at v over the span that contains u.
    private Piece Follow(double u, double v)
    {
        var span = _last is { } last && u >= last.From && u < last.To ? last : PieceAt(u);
        if (span.V != v)
        {
            _surface.AlongV(span.Number, v, span.Powers, span.Place, span.Slope);
            span.V = v;
        }

        return span;
    }

    private Piece PieceAt(double u)
    {
        var number = _surface.KnotsU.SpanAt(u);
        return _last = _pieces[number] ??= new(_surface.KnotsU, number);
    }

    private static Vector3 Space(Vector256<double> v) => new(v[0], v[1], v[2]);

    /// <summary>One polynomial piece along u, and the last line over it.</summary>
    private sealed class Piece
    {
        public Piece(KnotVector knots, int number)
        {
            var values = knots.Values;
            var half = (values[number + 1] - values[number]) / 2;
            (Number, Middle, PerUnit) = (number, values[number] + half, 1 / half);
            From = number == knots.SpanAt(knots.Start) ? double.NegativeInfinity : values[number];
            To = number == knots.SpanAt(knots.End) ? double.PositiveInfinity : values[number + 1];
            var width = knots.Degree + 1;
            Powers = new double[width * width];
            (Place, Slope) = (new Vector256<double>[width], new Vector256<double>[width]);
            knots.Basis.WithDerivatives(number, Middle, knots.Degree, Powers);
            var factor = 1.0;
            for (var k = 1; k < width; k++)
            {
                factor *= half / k;
                for (var i = 0; i < width; i++)
                {
                    Powers[(k * width) + i] *= factor;
                }
            }
        }

        public int Number { get; }

        /// <summary>The first parameter of the piece; minus infinity for the first piece.</summary>
        public double From { get; }

        /// <summary>The first parameter after the piece; plus infinity for the last piece.</summary>
        public double To { get; }

        public double Middle { get; }

        public double PerUnit { get; }

        /// <summary>The coefficients of the basis functions, power by power, in (u - middle) / half span.</summary>
        public double[] Powers { get; }

        public double V { get; set; } = double.NaN;

        /// <summary>The coefficients of the line.</summary>
        public Vector256<double>[] Place { get; }

        /// <summary>The coefficients of its derivative with respect to v.</summary>
        public Vector256<double>[] Slope { get; }

        public bool Holds(Vector256<double> u) =>
            Vector256.GreaterThanOrEqualAll(u, Vector256.Create(From)) && Vector256.LessThanAll(u, Vector256.Create(To));
    }
}
