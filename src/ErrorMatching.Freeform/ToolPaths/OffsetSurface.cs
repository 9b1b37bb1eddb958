using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Where the ball's center may be: the exact offset S + d n of a surface, and the surface S + s n that the ball leaves.</summary>
/// <remarks>Nothing is approximated: every place is evaluated from the surface's own derivatives. Derivatives of the unit normal: Piegl and Tiller, The NURBS Book, 2nd edition, section 11.4 (offsets). It keeps the line that it was asked about last: each thread needs its own.</remarks>
internal sealed class OffsetSurface
{
    // How far, as a share of the range, a normal is looked for beside a place that has none (a pole of a sphere).
    private const double Beside = 1e-7;

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

    /// <summary>Distance of the center from the surface.</summary>
    public double DistanceMm => RadiusMm + StockMm;

    /// <summary>The center over a place, with its derivatives.</summary>
    public CenterPoint At(double u, double v)
    {
        var at = _spline.At(u, v);
        var (place, du, dv) = (new Vector3(at.Position.X, at.Position.Y, at.Position.Z), at.Du, at.Dv);
        var cross = du.Cross(dv);
        var length = cross.Length;
        if (!(length > 1e-12 * (du.Dot(du) + dv.Dot(dv))))
        {
            return Degenerate(u, v, place);
        }

        var scale = _outside / length;
        var normal = cross * scale;
        var (crossU, crossV) = (at.Duu.Cross(dv) + du.Cross(at.Duv), at.Duv.Cross(dv) + du.Cross(at.Dvv));
        var normalU = (crossU * scale) - (normal * (normal.Dot(crossU) * scale));
        var normalV = (crossV * scale) - (normal * (normal.Dot(crossV) * scale));
        var distance = DistanceMm;
        var center = place + (normal * distance);
        return new(normal, new(center.X, center.Y, center.Z), du + (normalU * distance), dv + (normalV * distance));
    }

    /// <summary>The center over a place.</summary>
    public Point3 CenterAt(double u, double v)
    {
        var (place, normal) = Left(u, v);
        return place + (normal * RadiusMm);
    }

    /// <summary>A place on the surface that the ball leaves, and its unit normal out of the material.</summary>
    public (Point3 Place, Vector3 Normal) Left(double u, double v)
    {
        _line.At(u, v, out var on, out var du, out var dv);
        var cross = du.Cross(dv);
        var length = cross.Length;
        var normal = length > 1e-12 * (du.Dot(du) + dv.Dot(dv)) ? cross * (_outside / length) : At(u, v).Normal;
        var place = on + (normal * StockMm);
        return (new(place.X, place.Y, place.Z), normal);
    }

    // The normal of a pole is that beside it; where there is none either, it is zero.
    private CenterPoint Degenerate(double u, double v, Vector3 place)
    {
        var (besideU, besideV) = (u + ((_middle.X - u) * Beside), v + ((_middle.Y - v) * Beside));
        var normal = _spline.At(besideU, besideV).Normal * _outside;
        var center = place + (normal * DistanceMm);
        return new(normal, new(center.X, center.Y, center.Z), Vector3.Zero, Vector3.Zero);
    }
}
