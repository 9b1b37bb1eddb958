namespace ErrorMatching.Geometry;

/// <content>Knot removal.</content>
public sealed partial class SplineCurve
{
    /// <summary>The clamped curve with a knot once less, moved as little as that allows, its ends not at all.</summary>
    /// <param name="t">An inner knot.</param>
    /// <returns>The curve, and a bound in millimetres that no point of it is farther from the old one at the same parameter: the largest distance between their poles over the old knots. Rounding alone for a knot that says nothing.</returns>
    /// <exception cref="GeometryException">It is no inner knot, or a weight of the new curve would not be positive.</exception>
    public (SplineCurve Curve, double MovedMm) RemoveKnot(double t)
    {
        var rows = Rows().Onto(Knots.Clamp());
        var less = rows.Remove(t);
        return (From(less, IsRational), SplinePoles.Moved(rows.Values, less.Onto(rows.Knots).Values, IsRational));
    }
}
