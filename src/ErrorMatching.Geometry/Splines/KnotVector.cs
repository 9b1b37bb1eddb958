namespace ErrorMatching.Geometry;

/// <summary>The degree and knots of a B-spline: where its polynomial pieces meet, and how smoothly.</summary>
/// <remarks>The knots do not decrease, and their multiplicity is at most degree + 1. n poles of degree p need n + p + 1 knots. The
/// parameter ranges from knot p to knot n (<see cref="Start"/> to <see cref="End"/>). Algorithms and their numbers: Piegl and Tiller, The
/// NURBS Book, 2nd edition, chapter 2.</remarks>
public sealed partial class KnotVector : IEquatable<KnotVector>
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
}
