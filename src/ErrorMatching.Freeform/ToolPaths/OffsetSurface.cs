using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Calculates ball centers on the exact offset S + d n of a surface, and places on the surface S + s n that it leaves.</summary>
/// <remarks>Nothing is approximated: every place is evaluated from the surface's own derivatives. For derivatives of the unit normal, see
/// Piegl and Tiller, The NURBS Book, 2nd edition, section 11.4 (offsets). It caches a line, so each thread needs its own.</remarks>
internal sealed class OffsetSurface
{
    // How far, as a share of the range, a normal is looked for beside a place that has none (a pole of a sphere).
    private const double Beside = 1e-7;

    // Tangents whose vector product is shorter, as a share of their squares, have no normal.
    private const double Parallel = 1e-12;

    private readonly SplineSurface _spline;
    private readonly SurfaceLine _line;
    private readonly double _outside;
    private readonly Point2 _middle;

    public OffsetSurface(PartSurface surface, double radiusMm, double stockMm)
    {
        (Surface, _spline, _outside) = (surface, surface.Spline, surface.Outside);
        _line = new(_spline);
        (RadiusMm, StockMm) = (radiusMm, stockMm);
        _middle = new((_spline.KnotsU.Start + _spline.KnotsU.End) / 2, (_spline.KnotsV.Start + _spline.KnotsV.End) / 2);
    }

    public PartSurface Surface { get; }

    public double RadiusMm { get; }

    public double StockMm { get; }

    public double DistanceMm => RadiusMm + StockMm;

    public CenterPoint At(double u, double v) => Moving(u, v, default);

    /// <summary>The center over a place, with its derivative along a direction in the parameters. Along u, the calculation is several
    /// times as fast.</summary>
    public CenterPoint Moving(double u, double v, Vector2 along)
    {
        // Derivatives of position and of both tangents along the direction.
        Vector3 place, du, dv, velocity, turnU, turnV;
        if (along.Y == 0)
        {
            _line.At(u, v, out place, out du, out dv, out turnU, out turnV);
            (velocity, turnU, turnV) = (du * along.X, turnU * along.X, turnV * along.X);
        }
        else
        {
            var at = _spline.At(u, v);
            (place, du, dv) = (new(at.Position.X, at.Position.Y, at.Position.Z), at.Du, at.Dv);
            (velocity, turnU, turnV) = (
                (du * along.X) + (dv * along.Y), (at.Duu * along.X) + (at.Duv * along.Y), (at.Duv * along.X) + (at.Dvv * along.Y));
        }

        var cross = du.Cross(dv);
        var length = cross.Length;
        if (!(length > Parallel * (du.Dot(du) + dv.Dot(dv))))
        {
            return Degenerate(u, v, place);
        }

        var scale = _outside / length;
        var normal = cross * scale;
        var turn = turnU.Cross(dv) + du.Cross(turnV);
        var turning = (turn * scale) - (normal * (normal.Dot(turn) * scale));
        var center = place + (normal * DistanceMm);
        return new(normal, new(center.X, center.Y, center.Z), velocity + (turning * DistanceMm));
    }

    public Point3 CenterAt(double u, double v)
    {
        var (place, normal) = Left(u, v);
        return place + (normal * RadiusMm);
    }

    /// <summary>A place on the surface that the ball leaves, with its unit normal out of the material.</summary>
    public (Point3 Place, Vector3 Normal) Left(double u, double v)
    {
        _line.At(u, v, out var on, out var du, out var dv);
        var cross = du.Cross(dv);
        var length = cross.Length;
        var normal = length > Parallel * (du.Dot(du) + dv.Dot(dv)) ? cross * (_outside / length) : At(u, v).Normal;
        var place = on + (normal * StockMm);
        return (new(place.X, place.Y, place.Z), normal);
    }

    /// <summary>Four places on the surface that the ball leaves, with their unit normals, identical to the single results.</summary>
    /// <returns>False if one of them has no normal of its own; calculate them singly.</returns>
    public bool Left(Vector256<double> u, double v, out FourVectors places, out FourVectors normals)
    {
        _line.At(u, v, out places, out var du, out var dv);
        normals = du.Cross(dv);
        var length = normals.Length;
        if (!Vector256.GreaterThanAll(length, (du.Dot(du) + dv.Dot(dv)) * Parallel))
        {
            return false;
        }

        normals *= Vector256.Create(_outside) / length;
        places += normals * Vector256.Create(StockMm);
        return true;
    }

    // A pole takes a neighboring normal; if there is none either, the normal is zero.
    private CenterPoint Degenerate(double u, double v, Vector3 place)
    {
        var (besideU, besideV) = (u + ((_middle.X - u) * Beside), v + ((_middle.Y - v) * Beside));
        var normal = _spline.At(besideU, besideV).Normal * _outside;
        var center = place + (normal * DistanceMm);
        return new(normal, new(center.X, center.Y, center.Z), Vector3.Zero);
    }
}

/// <summary>The exact center of the ball where it touches the surface, and its derivative.</summary>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Center">Center of the ball.</param>
/// <param name="Velocity">Derivative of the center along a direction in the parameters.</param>
internal readonly record struct CenterPoint(Vector3 Normal, Point3 Center, Vector3 Velocity);
