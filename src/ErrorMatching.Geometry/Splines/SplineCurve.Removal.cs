namespace ErrorMatching.Geometry;

/// <content>Knot removal.</content>
public sealed partial class SplineCurve
{
    /// <summary>Removes a knot once from the clamped curve, moving it as little as possible. The ends do not move.</summary>
    /// <param name="t">An inner knot.</param>
    /// <returns>The curve, and a bound in millimeters of its displacement at the same parameter: the largest distance between the poles
    /// over the old knots. For a redundant knot, this is only rounding.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a weight of the new curve would not be
    /// positive.</exception>
    public (SplineCurve Curve, double MovedMm) RemoveKnot(double t)
    {
        var rows = Rows().Onto(Knots.Clamp());
        var less = rows.Remove(t);
        return (From(less, IsRational), SplinePoles.Moved(rows.Values, less.Onto(rows.Knots).Values, IsRational));
    }
}
