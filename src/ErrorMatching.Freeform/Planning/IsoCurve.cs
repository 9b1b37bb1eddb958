using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A curve of a surface along which one parameter varies and the other is fixed.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="AlongU">True if u varies.</param>
/// <param name="Fixed">The fixed parameter.</param>
internal sealed record IsoCurve(PartSurface Surface, bool AlongU, double Fixed)
{
    /// <summary>Knots of the varying parameter.</summary>
    public KnotVector Knots => AlongU ? Surface.Spline.KnotsU : Surface.Spline.KnotsV;

    public SurfacePoint At(double t) => AlongU ? Surface.Spline.At(t, Fixed) : Surface.Spline.At(Fixed, t);

    /// <summary>Which of its places belong to the piece.</summary>
    public RegionLine Line => new(Surface.Region, AlongU, Fixed);

    /// <summary>First derivative with respect to the parameter.</summary>
    public Vector3 Derivative(SurfacePoint at) => AlongU ? at.Du : at.Dv;

    /// <summary>Unit tangent; zero where the derivative vanishes.</summary>
    public Vector3 Tangent(SurfacePoint at)
    {
        var first = Derivative(at);
        var length = first.Length;
        return length > 0 ? first * (1 / length) : Vector3.Zero;
    }

    /// <summary>Curvature vector in 1/mm, towards the center of the osculating circle, its length one over the radius; zero where the
    /// derivative vanishes.</summary>
    public Vector3 Curvature(SurfacePoint at)
    {
        var (first, second) = (Derivative(at), AlongU ? at.Duu : at.Dvv);
        var square = first.Dot(first);
        return square > 0 ? (second - (first * (second.Dot(first) / square))) * (1 / square) : Vector3.Zero;
    }
}
