namespace ErrorMatching.Geometry;

/// <summary>The degree and knots of a B-spline: where its polynomial pieces meet, and how smoothly.</summary>
/// <remarks>The knots do not decrease, and their multiplicity is at most degree + 1. n poles of degree p need n + p + 1 knots. The
/// parameter ranges from knot p to knot n (<see cref="Start"/> to <see cref="End"/>). Algorithms and their numbers: Piegl and Tiller, The
/// NURBS Book, 2nd edition, chapter 2.</remarks>
public sealed class KnotVector : IEquatable<KnotVector>
{
    /// <summary>The highest supported degree. Beyond it, a B-spline loses digits, and no exchange format contains it.</summary>
    public const int MaxDegree = 25;

    private readonly double[] _values;

    /// <summary>Creates a knot vector.</summary>
    /// <param name="degree">1 to <see cref="MaxDegree"/>.</param>
    /// <param name="values">At least 2 (degree + 1) finite, nondecreasing numbers.</param>
    /// <exception cref="GeometryException">The degree or the knots are invalid for a B-spline.</exception>
    public KnotVector(int degree, ReadOnlySpan<double> values)
    {
        if (degree is < 1 or > MaxDegree)
        {
            throw new GeometryException(GeometryError.BadKnots, $"a B-spline of degree {degree}; degrees 1 to {MaxDegree} are expected");
        }

        if (values.Length < 2 * (degree + 1))
        {
            throw new GeometryException(
                GeometryError.BadKnots, $"{values.Length} knots for degree {degree}; at least {2 * (degree + 1)} are expected");
        }

        Check(degree, values);
        Degree = degree;
        _values = values.ToArray();
        if (!(Start < End))
        {
            throw new GeometryException(GeometryError.BadKnots, "the first and the last parameter of the B-spline are the same");
        }
    }

    /// <summary>Degree of the polynomial pieces.</summary>
    public int Degree { get; }

    /// <summary>All knots, repeated by multiplicity.</summary>
    public ReadOnlySpan<double> Values => _values;

    /// <summary>Number of poles.</summary>
    public int PoleCount => _values.Length - Degree - 1;

    /// <summary>First parameter.</summary>
    public double Start => _values[Degree];

    /// <summary>Last parameter.</summary>
    public double End => _values[PoleCount];

    /// <summary>True if the B-spline starts and ends at its first and last pole.</summary>
    public bool IsClamped => _values[0] == Start && _values[^1] == End;

    /// <summary>The parameters at which pieces start and end, without repetition, from <see cref="Start"/> to <see cref="End"/>.</summary>
    public IReadOnlyList<double> Breaks
    {
        get
        {
            var breaks = new List<double>();
            for (var i = Degree; i <= PoleCount; i++)
            {
                if (breaks.Count == 0 || _values[i] > breaks[^1])
                {
                    breaks.Add(_values[i]);
                }
            }

            return breaks;
        }
    }

    /// <summary>Clamped knots with given breaks, the inner ones of equal multiplicity.</summary>
    /// <param name="degree">1 to <see cref="MaxDegree"/>.</param>
    /// <param name="breaks">At least two ascending parameters. The first and the last have multiplicity degree + 1.</param>
    /// <param name="multiplicity">Multiplicity of each inner break, 1 to degree.</param>
    /// <exception cref="GeometryException">The degree or the breaks are invalid for a B-spline.</exception>
    public static KnotVector Clamped(int degree, ReadOnlySpan<double> breaks, int multiplicity = 1)
    {
        var values = new List<double>();
        for (var i = 0; i < breaks.Length; i++)
        {
            var times = i == 0 || i == breaks.Length - 1 ? degree + 1 : multiplicity;
            values.AddRange(Enumerable.Repeat(breaks[i], times));
        }

        return new(degree, values.ToArray());
    }

    /// <summary>The index of the knot at which the piece with a parameter starts. Outside, it is the first or last piece.</summary>
    public int SpanAt(double t)
    {
        if (t >= End)
        {
            var last = PoleCount - 1;
            while (_values[last] == _values[last + 1])
            {
                last--;
            }

            return last;
        }

        // Before the first parameter, the first nonempty piece continues.
        t = Math.Max(t, Start);
        var (low, high) = (Degree, PoleCount);
        while (high - low > 1)
        {
            var middle = (low + high) >> 1;
            if (t >= _values[middle])
            {
                low = middle;
            }
            else
            {
                high = middle;
            }
        }

        return low;
    }

    /// <summary>The multiplicity of a value among the knots.</summary>
    public int Multiplicity(double value)
    {
        var count = 0;
        foreach (var knot in _values)
        {
            count += knot == value ? 1 : 0;
        }

        return count;
    }

    /// <summary>The Greville abscissa: the mean of the degree knots that follow knot <paramref name="pole"/>, where the pole has most
    /// weight.</summary>
    public double Greville(int pole)
    {
        var sum = 0.0;
        for (var i = 1; i <= Degree; i++)
        {
            sum += _values[pole + i];
        }

        return Math.Clamp(sum / Degree, Start, End);
    }

    /// <inheritdoc/>
    public bool Equals(KnotVector? other) => other is not null && Degree == other.Degree && Values.SequenceEqual(other.Values);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as KnotVector);

    /// <inheritdoc/>
    public override int GetHashCode() => HashCode.Combine(Degree, _values.Length, Start, End);

    /// <summary>The basis functions over these knots.</summary>
    internal BasisFunctions Basis => new(Degree, _values);

    private static void Check(int degree, ReadOnlySpan<double> values)
    {
        var run = 1;
        for (var i = 0; i < values.Length; i++)
        {
            if (!double.IsFinite(values[i]))
            {
                throw new GeometryException(GeometryError.NotFinite, $"knot {i + 1} is no finite number");
            }

            if (i == 0)
            {
                continue;
            }

            if (values[i] < values[i - 1])
            {
                throw new GeometryException(GeometryError.BadKnots, $"knot {i + 1} is smaller than the one before it");
            }

            run = values[i] == values[i - 1] ? run + 1 : 1;
            if (run > degree + 1)
            {
                throw new GeometryException(GeometryError.BadKnots, $"knot {i + 1} is repeated more than {degree + 1} times");
            }
        }
    }

    // Knots derived from other knots.

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
