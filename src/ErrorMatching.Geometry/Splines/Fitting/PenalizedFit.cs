namespace ErrorMatching.Geometry;

/// <summary>Poles that balance the squared distances of points against a bending energy. Unless given, the weight of the energy minimizes
/// the generalized cross-validation m * (sum of squares) / (m - trace)^2, which predicts left-out points best (P. Craven and G. Wahba,
/// "Smoothing noisy data with spline functions", Numer. Math. 31, 1979).</summary>
internal sealed class PenalizedFit(int poles, int reach)
{
    private const int Decades = 15;
    private readonly int _width = Math.Min(reach + 1, poles);
    private readonly double[] _points = new double[poles * Math.Min(reach + 1, poles)];
    private readonly double[] _bending = new double[poles * Math.Min(reach + 1, poles)];
    private readonly double[] _rights = new double[poles * 3];
    private readonly List<(int[] Poles, double[] Factors, Point3 Point)> _equations = [];

    /// <summary>Adds a point with the basis functions of consecutive poles at its parameters.</summary>
    public void AddPoint(int first, ReadOnlySpan<double> factors, Point3 point) =>
        AddPoint([.. Enumerable.Range(first, factors.Length)], factors, point);

    /// <summary>Adds a point with the basis functions at its parameters.</summary>
    public void AddPoint(int[] numbers, ReadOnlySpan<double> factors, Point3 point)
    {
        if (!point.IsFinite)
        {
            throw new GeometryException(GeometryError.NotFinite, $"point {_equations.Count + 1} has a coordinate that is no finite number");
        }

        _equations.Add((numbers, factors.ToArray(), point));
        AddTo(_points, numbers, factors, 1);
        for (var i = 0; i < numbers.Length; i++)
        {
            var right = _rights.AsSpan(numbers[i] * 3);
            (right[0], right[1], right[2]) = (
                right[0] + (factors[i] * point.X), right[1] + (factors[i] * point.Y), right[2] + (factors[i] * point.Z));
        }
    }

    /// <summary>Adds one node of the integral of the energy, for consecutive poles.</summary>
    public void AddBending(int first, ReadOnlySpan<double> factors, double weight) =>
        AddTo(_bending, [.. Enumerable.Range(first, factors.Length)], factors, weight);

    /// <summary>Adds one node of the integral of the energy.</summary>
    public void AddBending(int[] numbers, ReadOnlySpan<double> factors, double weight) => AddTo(_bending, numbers, factors, weight);

    /// <summary>Returns the poles, the weight of the energy, and the effective number of parameters of the smoothed poles (the trace of
    /// the matrix from points to fitted points).</summary>
    /// <param name="weight">The weight; null selects it.</param>
    /// <exception cref="GeometryException">The points do not determine the poles even with the energy
    /// (<see cref="GeometryError.RankDeficient"/>).</exception>
    public (Point3[] Poles, double Weight, double EffectiveParameters) Solve(double? weight = null)
    {
        if (weight is { } given)
        {
            return Balanced(given) is { } balanced
                ? (LinePass.Points(balanced.Poles), given, _equations.Count - Freedom(balanced.Factors, given))
                : throw Undetermined();
        }

        var unit = Trace(_points) / Trace(_bending);
        var scores = Enumerable.Range(0, Decades).Select(d => Score(unit * Elementary.Pow(10, d - (Decades - 5)))).ToArray();
        var best = Array.IndexOf(scores, scores.Min());
        if (double.IsPositiveInfinity(scores[best]))
        {
            throw Undetermined();
        }

        var exponent = Refined(unit, best - (Decades - 5.0));
        return Solve(unit * Elementary.Pow(10, exponent));
    }

    /// <summary>Golden section search around the best power of ten.</summary>
    private double Refined(double unit, double best)
    {
        var golden = (Math.Sqrt(5) - 1) / 2;
        var (low, high) = (best - 1, best + 1);
        var (a, b) = (high - (golden * (high - low)), low + (golden * (high - low)));
        var (scoreA, scoreB) = (At(a), At(b));
        while (high - low > 0.1)
        {
            if (scoreA <= scoreB)
            {
                (high, b, scoreB) = (b, a, scoreA);
                a = high - (golden * (high - low));
                scoreA = At(a);
            }
            else
            {
                (low, a, scoreA) = (a, b, scoreB);
                b = low + (golden * (high - low));
                scoreB = At(b);
            }
        }

        // The score is flat near its minimum and may have several valleys, so the refined value must be no worse than the power of ten.
        var middle = scoreA <= scoreB ? a : b;
        return Math.Min(scoreA, scoreB) <= At(best) ? middle : best;

        double At(double exponent) => Score(unit * Elementary.Pow(10, exponent));
    }

    private double Score(double weight)
    {
        if (Balanced(weight) is not { } fit || Freedom(fit.Factors, weight) is not (> 0 and var freedom))
        {
            return double.PositiveInfinity;
        }

        var (_, squares) = Rest(fit.Poles, weight);
        return _equations.Count * squares / (freedom * freedom);
    }

    /// <summary>Points minus the trace of A^-1 G, with G = A - weight P, to avoid cancellation in a nearly exact fit.</summary>
    private double Freedom(BandedSymmetric factors, double weight) =>
        _equations.Count - poles + (weight * TraceOfProduct(factors.Inverse(), _bending));

    /// <summary>The fit for a weight; null if it is not determined to rounding.</summary>
    private (double[] Poles, BandedSymmetric Factors)? Balanced(double weight)
    {
        var matrix = new double[_points.Length];
        for (var i = 0; i < matrix.Length; i++)
        {
            matrix[i] = _points[i] + (weight * _bending[i]);
        }

        if (BandedSymmetric.Factor(matrix, poles, _width) is not { } factors)
        {
            return null;
        }

        var solution = (double[])_rights.Clone();
        factors.Solve(solution, 3);
        // Normal equations halve the digits. One step of iterative refinement restores them.
        var (rest, _) = Rest(solution, weight);
        factors.Solve(rest, 3);
        for (var i = 0; i < rest.Length; i++)
        {
            solution[i] += rest[i];
        }

        return (solution, factors);
    }

    /// <summary>The residual of the normal equations for fitted poles, from the points, and the sum of squared distances.</summary>
    private (double[] Left, double SquareSum) Rest(double[] solution, double weight)
    {
        var rest = new double[solution.Length];
        var squares = 0.0;
        foreach (var (numbers, factors, point) in _equations)
        {
            var (x, y, z) = (point.X, point.Y, point.Z);
            for (var i = 0; i < numbers.Length; i++)
            {
                var pole = solution.AsSpan(numbers[i] * 3, 3);
                (x, y, z) = (x - (factors[i] * pole[0]), y - (factors[i] * pole[1]), z - (factors[i] * pole[2]));
            }

            squares += (x * x) + (y * y) + (z * z);
            for (var i = 0; i < numbers.Length; i++)
            {
                var target = rest.AsSpan(numbers[i] * 3, 3);
                (target[0], target[1], target[2]) = (
                    target[0] + (factors[i] * x), target[1] + (factors[i] * y), target[2] + (factors[i] * z));
            }
        }

        for (var row = 0; row < poles; row++)
        {
            for (var column = Math.Max(0, row - _width + 1); column <= row; column++)
            {
                var factor = weight * _bending[(row * _width) + column - row + _width - 1];
                for (var c = 0; c < 3; c++)
                {
                    rest[(row * 3) + c] -= factor * solution[(column * 3) + c];
                    rest[(column * 3) + c] -= column < row ? factor * solution[(row * 3) + c] : 0;
                }
            }
        }

        return (rest, squares);
    }

    private void AddTo(double[] matrix, int[] numbers, ReadOnlySpan<double> factors, double weight)
    {
        for (var i = 0; i < numbers.Length; i++)
        {
            for (var j = 0; j <= i; j++)
            {
                matrix[(numbers[i] * _width) + numbers[j] - numbers[i] + _width - 1] += weight * factors[i] * factors[j];
            }
        }
    }

    private double Trace(double[] matrix)
    {
        var sum = 0.0;
        for (var i = 0; i < poles; i++)
        {
            sum += matrix[(i * _width) + _width - 1];
        }

        return sum;
    }

    private double TraceOfProduct(double[] a, double[] b)
    {
        var sum = 0.0;
        for (var row = 0; row < poles; row++)
        {
            for (var k = 0; k < _width; k++)
            {
                var at = (row * _width) + k;
                sum += (k < _width - 1 ? 2 : 1) * a[at] * b[at];
            }
        }

        return sum;
    }

    private static GeometryException Undetermined() => new(
        GeometryError.RankDeficient, "the points lie on one line in the parameters, or are fewer than three: they determine no smooth fit");
}
