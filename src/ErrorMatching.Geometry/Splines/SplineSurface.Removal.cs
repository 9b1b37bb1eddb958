namespace ErrorMatching.Geometry;

/// <content>Knot removal.</content>
public sealed partial class SplineSurface
{
    /// <summary>The clamped surface with a knot along u once less, moved as little as that allows, its edges at the ends of u not at all.</summary>
    /// <param name="u">An inner knot.</param>
    /// <returns>The surface, and a bound in millimetres that no point of it is farther from the old one at the same parameters: the largest distance between their poles over the old knots. Rounding alone for a knot that says nothing.</returns>
    /// <exception cref="GeometryException">It is no inner knot, or a weight of the new surface would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotU(double u) => Remove(r => r.Remove(u), r => r);

    /// <summary>The clamped surface with a knot along v once less; else as <see cref="RemoveKnotU"/>.</summary>
    /// <param name="v">An inner knot.</param>
    /// <returns>The surface, and a bound of how far it moved in millimetres.</returns>
    /// <exception cref="GeometryException">It is no inner knot, or a weight of the new surface would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotV(double v) => Remove(r => r, r => r.Remove(v));

    private (SplineSurface Surface, double MovedMm) Remove(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV)
    {
        var (u, v) = (KnotsU.Clamp(), KnotsV.Clamp());
        var old = Apply((KnotsU, KnotsV, Flat), Size, r => r.Onto(u), r => r.Onto(v));
        var less = Apply(old, Size, alongU, alongV);
        var back = Apply(less, Size, r => r.Onto(u), r => r.Onto(v));
        return (From(less, IsRational), SplinePoles.Moved(old.Values, back.Values, IsRational));
    }
}
