namespace ErrorMatching.Geometry;

/// <content>The same curve in other words: other knots, a higher degree, a part of it, backwards.</content>
public sealed partial class SplineCurve
{
    /// <summary>The curves over <see cref="KnotVector.Common"/> knots: one degree and the same knots for all, as skinning needs them. None moves.</summary>
    /// <remarks>Curves with other ranges are stretched onto the range of the first. Knots that are told apart only by rounding (<see cref="KnotVector.SameKnot"/>) fall together, which moves a curve by no more than that share of its length.</remarks>
    /// <param name="curves">At least one.</param>
    /// <exception cref="GeometryException">There are none.</exception>
    public static IReadOnlyList<SplineCurve> Compatible(IReadOnlyList<SplineCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(curves);
        var common = KnotVector.Common([.. curves.Select(c => c.Knots)]);
        return [.. curves.Select(c => From(c.Rows().Snap(common).ElevateTo(common.Degree).Onto(common), c.IsRational))];
    }

    /// <summary>The same curve over knots that contain its own (knot insertion, Oslo algorithm).</summary>
    /// <param name="finer">Clamped knots of the same degree with the same range, or with a part of it: then that part.</param>
    /// <exception cref="GeometryException">The knots do not contain the curve's.</exception>
    public SplineCurve WithKnots(KnotVector finer)
    {
        ArgumentNullException.ThrowIfNull(finer);
        return From(Rows().Onto(finer), IsRational);
    }

    /// <summary>The same curve, clamped, with a knot more.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <param name="times">How often it is added.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or would count more than degree + 1 times.</exception>
    public SplineCurve InsertKnot(double t, int times = 1) => WithKnots(Knots.Insert(t, times));

    /// <summary>The same curve, clamped, with a higher degree.</summary>
    /// <param name="degree">Not lower than the curve's and not higher than <see cref="KnotVector.MaxDegree"/>.</param>
    /// <exception cref="GeometryException">The degree is none of these.</exception>
    public SplineCurve ElevateTo(int degree) => From(Rows().ElevateTo(degree), IsRational);

    /// <summary>The part of the curve between two parameters.</summary>
    /// <param name="from">First parameter.</param>
    /// <param name="to">Last parameter.</param>
    /// <exception cref="GeometryException">The part is empty or reaches beyond the curve.</exception>
    public SplineCurve Between(double from, double to) => WithKnots(Knots.Between(from, to));

    /// <summary>The curve before and after a parameter.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineCurve Before, SplineCurve After) Split(double t) => (Between(Knots.Start, t), Between(t, Knots.End));

    /// <summary>The same curve beginning and ending at its first and last pole.</summary>
    public SplineCurve Clamp() => WithKnots(Knots.Clamp());

    /// <summary>The curve run through backwards, over the same range of parameters.</summary>
    public SplineCurve Reverse() => From(Rows().Reverse(), IsRational);

    /// <summary>The same curve over another range of parameters.</summary>
    /// <param name="start">New first parameter.</param>
    /// <param name="end">New last parameter, larger than the first.</param>
    /// <exception cref="GeometryException">The range is empty.</exception>
    public SplineCurve Reparametrize(double start, double end) => new(Knots.Affine(start, end), _poles, _weights);

    /// <summary>The polynomial pieces in order, each a Bezier curve over its own part of the parameters.</summary>
    public IReadOnlyList<SplineCurve> Pieces()
    {
        var breaks = Knots.Breaks;
        var rows = Rows();
        return [.. breaks.Skip(1).Select((to, i) => From(rows.Onto(Knots.Between(breaks[i], to)), IsRational))];
    }

    /// <summary>A box that holds the curve: that of its poles.</summary>
    public Box3 Box() => Box3.Around(Clamp()._poles);

    internal static SplineCurve From(SplineRows rows, bool rational)
    {
        var (poles, weights) = SplinePoles.Unflatten(rows.Values, rational);
        return new(rows.Knots, poles, weights);
    }

    internal SplineRows Rows() => new(Knots, SplinePoles.Flatten(_poles, _weights), IsRational ? 4 : 3);
}
