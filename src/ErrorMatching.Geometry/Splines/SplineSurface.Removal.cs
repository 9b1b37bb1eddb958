namespace ErrorMatching.Geometry;

/// <content>Knot removal.</content>
public sealed partial class SplineSurface
{
    /// <summary>Removes a knot along u once from the clamped surface, moving it as little as possible. The edges at the ends of u do not
    /// move.</summary>
    /// <param name="u">An inner knot.</param>
    /// <returns>The surface, and a bound in millimeters of its displacement at the same parameters: the largest distance between the poles
    /// over the old knots. For a redundant knot, this is only rounding.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a new weight would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotU(double u) => Remove(r => r.Remove(u), r => r);

    /// <summary>Removes a knot along v once from the clamped surface, as in <see cref="RemoveKnotU"/>.</summary>
    /// <param name="v">An inner knot.</param>
    /// <returns>The surface, and a bound of its displacement in millimeters.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a new weight would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotV(double v) => Remove(r => r, r => r.Remove(v));

    private (SplineSurface Surface, double MovedMm) Remove(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV)
    {
        var (u, v) = (KnotsU.Clamp(), KnotsV.Clamp());
        var old = _poles.Rows().Each(r => r.Onto(u), r => r.Onto(v));
        var less = old.Each(alongU, alongV);
        var back = less.Each(r => r.Onto(u), r => r.Onto(v));
        return (new(less, IsRational), SplinePoles.Moved(old.Values, back.Values, IsRational));
    }
}
