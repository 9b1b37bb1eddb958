using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A curve of a surface along which one parameter runs and the other stays.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="AlongU">True if u runs.</param>
/// <param name="Fixed">The parameter that stays.</param>
internal sealed record IsoCurve(PartSurface Surface, bool AlongU, double Fixed)
{
    /// <summary>Knots of the parameter that runs.</summary>
    public KnotVector Knots => AlongU ? Surface.Spline.KnotsU : Surface.Spline.KnotsV;

    /// <summary>The place of the surface at a parameter.</summary>
    public SurfacePoint At(double t) => AlongU ? Surface.Spline.At(t, Fixed) : Surface.Spline.At(Fixed, t);

    /// <summary>Which of its places belong to the piece.</summary>
    public RegionLine Line => new(Surface.Region, AlongU, Fixed);

    /// <summary>First derivative by the parameter.</summary>
    public Vector3 Derivative(SurfacePoint at) => AlongU ? at.Du : at.Dv;

    /// <summary>Unit tangent; zero where the curve stands still.</summary>
    public Vector3 Tangent(SurfacePoint at)
    {
        var first = Derivative(at);
        var length = first.Length;
        return length > 0 ? first * (1 / length) : Vector3.Zero;
    }

    /// <summary>Curvature vector in 1/mm: towards the center of the osculating circle, as long as one over its radius; zero where the curve stands still.</summary>
    public Vector3 Curvature(SurfacePoint at)
    {
        var (first, second) = (Derivative(at), AlongU ? at.Duu : at.Dvv);
        var square = first.Dot(first);
        return square > 0 ? (second - (first * (second.Dot(first) / square))) * (1 / square) : Vector3.Zero;
    }
}
