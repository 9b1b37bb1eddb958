namespace ErrorMatching.Geometry;

/// <content>Other representations of the same curve: other knots, a higher degree, a part, reversed.</content>
public sealed partial class SplineCurve
{
    /// <summary>Converts curves to <see cref="KnotVector.Common"/> knots: one degree and the same knots for all, as needed for skinning.
    /// The curves do not move.</summary>
    /// <remarks>Other ranges are mapped to the range of the first curve. Knots that differ by rounding only
    /// (<see cref="KnotVector.SameKnot"/>) are merged, which moves a curve by at most that share of its length.</remarks>
    /// <param name="curves">At least one.</param>
    /// <exception cref="GeometryException">The list is empty.</exception>
    public static IReadOnlyList<SplineCurve> Compatible(IReadOnlyList<SplineCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(curves);
        var common = KnotVector.Common([.. curves.Select(c => c.Knots)]);
        return [.. curves.Select(c => From(c.Rows().Snap(common).ElevateTo(common.Degree).Onto(common), c.IsRational))];
    }

    /// <summary>The same curve over knots that contain its own (knot insertion, Oslo algorithm).</summary>
    /// <param name="finer">Clamped knots of the same degree over the same range, or over a part of it, which gives that part.</param>
    /// <exception cref="GeometryException">The knots do not contain the curve's.</exception>
    public SplineCurve WithKnots(KnotVector finer)
    {
        ArgumentNullException.ThrowIfNull(finer);
        return From(Rows().Onto(finer), IsRational);
    }

    /// <summary>The same curve, clamped, with an additional knot.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineCurve InsertKnot(double t, int times = 1) => WithKnots(Knots.Insert(t, times));

    /// <summary>The same curve, clamped, with a higher degree.</summary>
    /// <param name="degree">From the curve's degree to <see cref="KnotVector.MaxDegree"/>.</param>
    /// <exception cref="GeometryException">The degree is out of range.</exception>
    public SplineCurve ElevateTo(int degree) => From(Rows().ElevateTo(degree), IsRational);

    /// <summary>The part of the curve between two parameters.</summary>
    /// <param name="from">First parameter.</param>
    /// <param name="to">Last parameter.</param>
    /// <exception cref="GeometryException">The part is empty or exceeds the curve.</exception>
    public SplineCurve Between(double from, double to) => WithKnots(Knots.Between(from, to));

    /// <summary>The curve before and after a parameter.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineCurve Before, SplineCurve After) Split(double t) => (Between(Knots.Start, t), Between(t, Knots.End));

    /// <summary>The same curve, starting and ending at its first and last pole.</summary>
    public SplineCurve Clamp() => WithKnots(Knots.Clamp());

    /// <summary>The reversed curve, over the same parameter range.</summary>
    public SplineCurve Reverse() => From(Rows().Reverse(), IsRational);

    /// <summary>The same curve over another parameter range.</summary>
    /// <param name="start">New first parameter.</param>
    /// <param name="end">New last parameter, larger than the first.</param>
    /// <exception cref="GeometryException">The range is empty.</exception>
    public SplineCurve Reparametrize(double start, double end) => new(Knots.Affine(start, end), _poles, _weights);

    /// <summary>The polynomial pieces in order, each a Bezier curve over its part of the parameters.</summary>
    public IReadOnlyList<SplineCurve> Pieces()
    {
        var breaks = Knots.Breaks;
        var rows = Rows();
        return [.. breaks.Skip(1).Select((to, i) => From(rows.Onto(Knots.Between(breaks[i], to)), IsRational))];
    }

    /// <summary>A box that contains the curve: that of its poles.</summary>
    public Box3 Box() => Box3.Around(Clamp()._poles);

    internal static SplineCurve From(SplineRows rows, bool rational)
    {
        var (poles, weights) = SplinePoles.Unflatten(rows.Values, rational);
        return new(rows.Knots, poles, weights);
    }

    internal SplineRows Rows() => new(Knots, SplinePoles.Flatten(_poles, _weights), IsRational ? 4 : 3);
}
