namespace ErrorMatching.Geometry;

/// <content>Knots derived from other knots.</content>
public sealed partial class KnotVector
{
    /// <summary>Knots of different curves that are closer than this share of the range are one knot in <see cref="Common"/>: they differ
    /// by rounding only.</summary>
    public const double SameKnot = 1e-10;

    /// <summary>The smallest clamped knot vector that contains the given ones: of the highest degree, over the range of the first, each
    /// break as smooth as in the least smooth one.</summary>
    /// <remarks>Other ranges are mapped to the first one's. Breaks that differ by less than <see cref="SameKnot"/> of the range are merged
    /// with the first in the list.</remarks>
    /// <param name="all">At least one.</param>
    /// <exception cref="GeometryException">The list is empty.</exception>
    public static KnotVector Common(IReadOnlyList<KnotVector> all)
    {
        ArgumentNullException.ThrowIfNull(all);
        if (all.Count == 0)
        {
            throw new GeometryException(GeometryError.BadKnots, "no knots to be made common; at least one curve is expected");
        }

        var degree = all.Max(k => k.Degree);
        var (start, end) = (all[0].Start, all[0].End);
        var breaks = new SortedList<double, int> { [start] = degree + 1, [end] = degree + 1 };
        foreach (var knots in all)
        {
            var stretched = knots.Affine(start, end);
            foreach (var value in stretched.Breaks)
            {
                var same = Nearest(breaks.Keys, value);
                var at = Math.Abs(same - value) <= SameKnot * (end - start) ? same : value;
                var needed = stretched.Multiplicity(value) + degree - knots.Degree;
                breaks[at] = Math.Max(breaks.GetValueOrDefault(at), Math.Min(needed, degree + 1));
            }
        }

        return new(degree, [.. breaks.SelectMany(b => Enumerable.Repeat(b.Key, b.Value))]);
    }

    /// <summary>The knots mapped to another range.</summary>
    /// <param name="start">New first parameter.</param>
    /// <param name="end">New last parameter, larger than the first.</param>
    /// <exception cref="GeometryException">The range is empty, or so small that knots coincide.</exception>
    public KnotVector Affine(double start, double end)
    {
        var (from, to) = (Start, End);
        if (from == start && to == end)
        {
            return this;
        }

        var values = new double[_values.Length];
        for (var i = 0; i < values.Length; i++)
        {
            var x = _values[i];
            values[i] = x == from ? start : x == to ? end : start + ((end - start) * ((x - from) / (to - from)));
        }

        return new(Degree, values);
    }

    /// <summary>The knots of the reversed curve, over the same range.</summary>
    public KnotVector Reverse()
    {
        var (start, end) = (Start, End);
        var values = new double[_values.Length];
        for (var i = 0; i < values.Length; i++)
        {
            var x = _values[^(i + 1)];
            values[i] = x == start ? end : x == end ? start : start + (end - x);
        }

        return new(Degree, values);
    }

    /// <summary>The knots clamped at both ends of a part of the range.</summary>
    /// <param name="from">First parameter, not before <see cref="Start"/>.</param>
    /// <param name="to">Last parameter, not after <see cref="End"/>.</param>
    /// <exception cref="GeometryException">The part is empty or exceeds the range.</exception>
    public KnotVector Between(double from, double to)
    {
        if (!(from >= Start && from < to && to <= End))
        {
            throw new GeometryException(
                GeometryError.BadKnots, FormattableString.Invariant($"parameters {from} to {to}; a part of {Start} to {End} is expected"));
        }

        double[] ends = [.. Enumerable.Repeat(from, Degree + 1), .. Enumerable.Repeat(to, Degree + 1)];
        return new(Degree, [.. ends[..(Degree + 1)], .. _values.Where(t => t > from && t < to), .. ends[(Degree + 1)..]]);
    }

    /// <summary>The knots clamped at both ends.</summary>
    public KnotVector Clamp() => IsClamped && _values[Degree + 1] > Start && _values[PoleCount - 1] < End ? this : Between(Start, End);

    /// <summary>The clamped knots with a knot inserted.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public KnotVector Insert(double t, int times = 1)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(times);
        if (!(t > Start && t < End))
        {
            throw new GeometryException(
                GeometryError.BadKnots, FormattableString.Invariant($"a knot at {t}; one between {Start} and {End} is expected"));
        }

        var clamped = Clamp();
        return new(Degree, [.. clamped._values.Where(k => k <= t), .. Enumerable.Repeat(t, times), .. clamped._values.Where(k => k > t)]);
    }

    /// <summary>The clamped knots of a higher degree for the same curves: every multiplicity grows with the degree.</summary>
    /// <param name="degree">Not lower than <see cref="Degree"/>.</param>
    /// <exception cref="GeometryException">The degree is lower, or higher than <see cref="MaxDegree"/>.</exception>
    public KnotVector ElevateTo(int degree)
    {
        if (degree < Degree)
        {
            throw new GeometryException(
                GeometryError.BadKnots, $"degree {degree} for knots of degree {Degree}; a degree can only be raised");
        }

        var clamped = Clamp();
        return new(degree, [.. clamped.Breaks.SelectMany(b => Enumerable.Repeat(b, clamped.Multiplicity(b) + degree - Degree))]);
    }

    /// <summary>The indices of the knots at which the pieces start, as in <see cref="SpanAt"/>.</summary>
    internal int[] Spans() => [.. Enumerable.Range(Degree, PoleCount - Degree).Where(i => _values[i + 1] > _values[i])];

    /// <summary>The knots that affect one piece.</summary>
    /// <param name="span">The piece, from <see cref="SpanAt"/>.</param>
    internal KnotVector OfPiece(int span) => new(Degree, _values.AsSpan(span - Degree, 2 * (Degree + 1)));

    private static double Nearest(IList<double> sorted, double value)
    {
        var best = sorted[0];
        foreach (var x in sorted)
        {
            best = Math.Abs(x - value) < Math.Abs(best - value) ? x : best;
        }

        return best;
    }
}
