namespace ErrorMatching.Freeform;

/// <summary>Predicts the error at each measured point from its neighbors alone.</summary>
/// <remarks>A quadratic in u and v is fitted to the <see cref="Neighbors"/> nearest other points, with tricube weights by distance, as in
/// Cleveland, "Robust Locally Weighted Regression and Smoothing Scatterplots", 1979, equation (2.1). With u and v relative to the point,
/// the prediction is the constant of the fit. Project the columns sqrt(w) (u, v, u^2, u v, v^2) out of the column c = sqrt(w): q = c -
/// projection. The prediction is then the sum of l_m e_m with l_m = sqrt(w_m) q_m / q^2 (Frisch, Waugh and Lovell). Its variance is the
/// leverage, the sum of l_m^2, times that of one point: about 0.3 in the middle, and more at edges and corners, where the fit
/// extrapolates.</remarks>
internal sealed class NeighborPrediction
{
    /// <summary>Number of points that predict one.</summary>
    public const int Neighbors = 16;

    /// <summary>Number of these that are adjacent to it on a grid.</summary>
    public const int Next = 8;

    // Weights reach zero at this multiple of the furthest neighbor's distance, so that it still has some weight.
    private const double Reach = 1.2;

    private const int Terms = 6;

    // A column depends on the others if less than this share of its square remains, such as v^2 with two curves.
    private const double Dependent = 1e-10;

    private readonly double[] _x;
    private readonly double[] _y;
    private readonly double[] _errors;
    private readonly int[] _order;
    private readonly int[] _place;
    private readonly int[] _neighbors;
    private readonly bool[] _aside;
    private readonly double[] _residuals;
    private readonly double[] _standardized;
    private readonly double[] _squares = new double[Neighbors];
    private readonly double[] _roots = new double[Neighbors];
    private readonly double[] _columns = new double[Terms * Neighbors];

    /// <summary>Predicts all points.</summary>
    /// <param name="samples">More than <see cref="Neighbors"/> errors on the curves of a grid.</param>
    public NeighborPrediction(IReadOnlyList<ErrorSample> samples)
    {
        var n = samples.Count;
        (_x, _y, _errors) = (new double[n], new double[n], new double[n]);
        var (first, last) = (samples[0].J, samples[0].J);
        for (var k = 0; k < n; k++)
        {
            (_x[k], _y[k], _errors[k]) = (samples[k].U, samples[k].V, samples[k].ErrorMm);
            (first, last) = (Math.Min(first, samples[k].J), Math.Max(last, samples[k].J));
        }

        // In mean point spacings, so that neighborhoods contain equally many points in both directions. Points are sorted along the longer
        // direction, where fewer of them are within a distance.
        var curves = last - first + 1;
        if (Scaled(_x, ((double)n / curves) - 1) < Scaled(_y, curves - 1))
        {
            (_x, _y) = (_y, _x);
        }

        (_order, _place) = (new int[n], new int[n]);
        for (var k = 0; k < n; k++)
        {
            _order[k] = k;
        }

        Array.Sort(_order, (a, b) => _x[a] != _x[b] ? _x[a].CompareTo(_x[b]) : a.CompareTo(b));
        for (var at = 0; at < n; at++)
        {
            _place[_order[at]] = at;
        }

        (_neighbors, _aside, _residuals, _standardized) = (new int[n * Neighbors], new bool[n], new double[n], new double[n]);
        for (var k = 0; k < n; k++)
        {
            Predict(k);
        }
    }

    /// <summary>Error minus prediction of each point, in millimeters; NaN if the neighbors do not determine a prediction.</summary>
    public IReadOnlyList<double> Residuals => _residuals;

    /// <summary>The residuals divided by sqrt(1 + leverage). In smooth fields, all have the standard deviation of the noise.</summary>
    public IReadOnlyList<double> Standardized => _standardized;

    /// <summary>True for a point that is excluded from predictions.</summary>
    public bool IsAside(int k) => _aside[k];

    /// <summary>Excludes a point from the prediction of others.</summary>
    public void SetAside(int k)
    {
        _aside[k] = true;
        for (var other = 0; other < _x.Length; other++)
        {
            foreach (var neighbor in NeighborsOf(other))
            {
                if (neighbor == k)
                {
                    Predict(other);
                    break;
                }
            }
        }
    }

    public void PutBack(int k)
    {
        _aside[k] = false;
        for (var other = 0; other < _x.Length; other++)
        {
            Predict(other);
        }
    }

    /// <summary>Robust standard deviation of the standardized residuals of all points that are not excluded.</summary>
    public double Scale()
    {
        var sizes = new double[_x.Length];
        var count = 0;
        for (var k = 0; k < _x.Length; k++)
        {
            if (!_aside[k] && !double.IsNaN(_standardized[k]))
            {
                sizes[count++] = Math.Abs(_standardized[k]);
            }
        }

        Array.Sort(sizes, 0, count);
        return count == 0 ? 0 : 1.4826 * (sizes[(count - 1) / 2] + sizes[count / 2]) / 2;
    }

    /// <summary>Largest minus smallest error of all points except one and the excluded ones.</summary>
    public double SpreadWithout(int k)
    {
        var (least, largest) = (double.MaxValue, double.MinValue);
        for (var other = 0; other < _x.Length; other++)
        {
            if (other != k && !_aside[other])
            {
                (least, largest) = (Math.Min(least, _errors[other]), Math.Max(largest, _errors[other]));
            }
        }

        return largest - least;
    }

    /// <summary>The second smallest difference between the errors of a point and its adjacent points.</summary>
    public double SecondNearestError(int k)
    {
        var (least, second) = (double.MaxValue, double.MaxValue);
        foreach (var next in NeighborsOf(k)[..Next])
        {
            var difference = Math.Abs(_errors[next] - _errors[k]);
            (least, second) = difference < least ? (difference, least) : (least, Math.Min(second, difference));
        }

        return second;
    }

    private Span<int> NeighborsOf(int k) => _neighbors.AsSpan(k * Neighbors, Neighbors);

    private Span<double> Column(int term) => _columns.AsSpan(term * Neighbors, Neighbors);

    private void Predict(int k)
    {
        var neighbors = NeighborsOf(k);
        Find(k, neighbors);
        var reach = Reach * Math.Sqrt(_squares[^1]);
        for (var m = 0; m < Neighbors; m++)
        {
            var (dx, dy) = (_x[neighbors[m]] - _x[k], _y[neighbors[m]] - _y[k]);
            var share = reach > 0 ? Math.Sqrt(_squares[m]) / reach : 0;
            var weight = 1 - (share * share * share);
            var root = Math.Sqrt(weight * weight * weight);
            _roots[m] = root;
            (
                Column(0)[m],
                Column(1)[m],
                Column(2)[m],
                Column(3)[m],
                Column(4)[m],
                Column(5)[m]) = (root * dx, root * dy, root * dx * dx, root * dx * dy, root * dy * dy, root);
        }

        if (!TakeOutOfLast())
        {
            (_residuals[k], _standardized[k]) = (double.NaN, double.NaN);
            return;
        }

        var q = Column(Terms - 1);
        var (said, squares, square) = (0.0, 0.0, Dot(q, q));
        for (var m = 0; m < Neighbors; m++)
        {
            var weight = _roots[m] * q[m] / square;
            said += weight * _errors[neighbors[m]];
            squares += weight * weight;
        }

        _residuals[k] = _errors[k] - said;
        _standardized[k] = _residuals[k] / Math.Sqrt(1 + squares);
    }

    /// <summary>Orthonormalizes the columns, and orthogonalizes the last one to all others (modified Gram-Schmidt).</summary>
    /// <returns>False if nothing remains of the last.</returns>
    private bool TakeOutOfLast()
    {
        for (var t = 0; t < Terms; t++)
        {
            var column = Column(t);
            var before = Dot(column, column);
            for (var s = 0; s < t; s++)
            {
                var unit = Column(s);
                var share = Dot(column, unit);
                for (var m = 0; m < Neighbors; m++)
                {
                    column[m] -= share * unit[m];
                }
            }

            var after = Dot(column, column);
            var depends = !(after > Dependent * before);
            if (t == Terms - 1)
            {
                return !depends;
            }

            var length = depends ? double.PositiveInfinity : Math.Sqrt(after);
            for (var m = 0; m < Neighbors; m++)
            {
                column[m] /= length;
            }
        }

        return false;
    }

    /// <summary>Finds the nearest other points, nearest first. It searches outward in the order of x until all further points are more
    /// distant.</summary>
    private void Find(int k, Span<int> neighbors)
    {
        var count = 0;
        var (below, above) = (_place[k] - 1, _place[k] + 1);
        while (below >= 0 || above < _order.Length)
        {
            var toBelow = below >= 0 ? _x[k] - _x[_order[below]] : double.PositiveInfinity;
            var toAbove = above < _order.Length ? _x[_order[above]] - _x[k] : double.PositiveInfinity;
            var along = Math.Min(toBelow, toAbove);
            if (count == Neighbors && along * along > _squares[^1])
            {
                break;
            }

            var other = toBelow <= toAbove ? _order[below--] : _order[above++];
            var across = _y[other] - _y[k];
            var square = (along * along) + (across * across);
            if (_aside[other] || (count == Neighbors && square >= _squares[^1]))
            {
                continue;
            }

            var at = count < Neighbors ? count++ : Neighbors - 1;
            for (; at > 0 && _squares[at - 1] > square; at--)
            {
                (_squares[at], neighbors[at]) = (_squares[at - 1], neighbors[at - 1]);
            }

            (_squares[at], neighbors[at]) = (square, other);
        }
    }

    private static double Dot(ReadOnlySpan<double> a, ReadOnlySpan<double> b)
    {
        var sum = 0.0;
        for (var m = 0; m < a.Length; m++)
        {
            sum += a[m] * b[m];
        }

        return sum;
    }

    /// <summary>Scales values to the range from 0 to a number of steps.</summary>
    /// <returns>The number of steps; zero if all values are equal.</returns>
    private static double Scaled(double[] values, double steps)
    {
        var (least, largest) = (double.MaxValue, double.MinValue);
        foreach (var value in values)
        {
            (least, largest) = (Math.Min(least, value), Math.Max(largest, value));
        }

        var unit = largest > least ? steps / (largest - least) : 0;
        for (var k = 0; k < values.Length; k++)
        {
            values[k] = (values[k] - least) * unit;
        }

        return largest > least ? steps : 0;
    }
}
