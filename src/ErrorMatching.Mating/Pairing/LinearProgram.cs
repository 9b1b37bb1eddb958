namespace ErrorMatching.Mating;

/// <summary>A linear program with few unknowns and many limits: the largest value of a sum while no row exceeds its limit.</summary>
/// <remarks>The dual simplex method (C. E. Lemke, 1954): the basis stays optimal for its own rows, and the row that is exceeded the most
/// enters until none is. It starts from the basis of the last program whose limits differ, where few steps are left. A step costs one pass
/// over the rows. Where steps gain nothing, the first row that is exceeded enters, which ends (R. G. Bland, 1977).</remarks>
internal sealed class LinearProgram
{
    // Rows are scaled to about 1, limits are millimeters: a picometer is rounding.
    private const double Exceeded = 1e-10, Nothing = 1e-11;

    // Steps after which the careful rule takes over, and after which a defect is assumed.
    private const int Careful = 200, Most = 20000;

    private readonly int _unknowns;
    private readonly double[] _rows;
    private readonly double[] _objective;
    private readonly int[] _basis;
    private readonly double[] _inverse;
    private readonly double[] _x;
    private readonly double[] _multipliers;
    private readonly double[] _shares;

    /// <summary>Prepares a program.</summary>
    /// <param name="unknowns">Number of unknowns.</param>
    /// <param name="rows">The rows, one behind the other.</param>
    /// <param name="objective">The weights of the sum.</param>
    /// <param name="basis">As many rows as there are unknowns, of which the objective is a sum with no negative weight.</param>
    public LinearProgram(int unknowns, double[] rows, double[] objective, int[] basis)
    {
        (_unknowns, _rows, _objective, _basis) = (unknowns, rows, objective, basis);
        _inverse = new double[unknowns * unknowns];
        (_x, _multipliers, _shares) = (new double[unknowns], new double[unknowns], new double[unknowns]);
    }

    /// <summary>The unknowns of the last solution.</summary>
    public IReadOnlyList<double> X => _x;

    /// <summary>The rows that determine it.</summary>
    public IReadOnlyList<int> Basis => _basis;

    /// <summary>By how much the largest value grows per limit of these rows.</summary>
    public IReadOnlyList<double> Multipliers => _multipliers;

    /// <summary>The largest value.</summary>
    public double Value
    {
        get
        {
            var sum = 0.0;
            for (var i = 0; i < _unknowns; i++)
            {
                sum += _objective[i] * _x[i];
            }

            return sum;
        }
    }

    /// <summary>Solves the program for limits, from the last basis.</summary>
    /// <param name="limits">The limit of each row.</param>
    /// <returns>False if the limits contradict each other.</returns>
    public bool Solve(ReadOnlySpan<double> limits)
    {
        Invert();
        for (var step = 0; step < Most; step++)
        {
            Place(limits);
            var entering = Worst(limits, isFirst: step > Careful);
            if (entering < 0)
            {
                return true;
            }

            var leaving = Leaving(entering);
            if (leaving < 0)
            {
                return false;
            }

            Exchange(leaving, entering);
        }

        throw new InvalidOperationException("The linear program does not end.");
    }

    private void Place(ReadOnlySpan<double> limits)
    {
        for (var i = 0; i < _unknowns; i++)
        {
            var sum = 0.0;
            for (var b = 0; b < _unknowns; b++)
            {
                sum += _inverse[(i * _unknowns) + b] * limits[_basis[b]];
            }

            _x[i] = sum;
        }
    }

    private int Worst(ReadOnlySpan<double> limits, bool isFirst)
    {
        var (worst, most) = (-1, Exceeded);
        if (_unknowns == 4)
        {
            // The program of a seat, which is solved for each draw.
            var (m, x, y, w) = (_x[0], _x[1], _x[2], _x[3]);
            for (int k = 0, r = 0; k < limits.Length; k++, r += 4)
            {
                var beyond = (_rows[r] * m) + (_rows[r + 1] * x) + (_rows[r + 2] * y) + (_rows[r + 3] * w) - limits[k];
                if (beyond > most)
                {
                    (worst, most) = (k, beyond);
                    if (isFirst)
                    {
                        return worst;
                    }
                }
            }

            return worst;
        }

        for (var k = 0; k < limits.Length; k++)
        {
            var beyond = -limits[k];
            for (var i = 0; i < _unknowns; i++)
            {
                beyond += _rows[(k * _unknowns) + i] * _x[i];
            }

            if (beyond > most)
            {
                (worst, most) = (k, beyond);
                if (isFirst)
                {
                    return worst;
                }
            }
        }

        return worst;
    }

    // The row of the basis whose multiplier is used up first. Of equal ones, the first row, so that the same program ends the same.
    private int Leaving(int entering)
    {
        var (leaving, least) = (-1, double.PositiveInfinity);
        for (var b = 0; b < _unknowns; b++)
        {
            var (share, multiplier) = (0.0, 0.0);
            for (var i = 0; i < _unknowns; i++)
            {
                share += _rows[(entering * _unknowns) + i] * _inverse[(i * _unknowns) + b];
                multiplier += _objective[i] * _inverse[(i * _unknowns) + b];
            }

            _shares[b] = share;
            if (share <= Nothing)
            {
                continue;
            }

            var ratio = Math.Max(0, multiplier) / share;
            if (ratio < least || (ratio == least && _basis[b] < _basis[leaving]))
            {
                (leaving, least) = (b, ratio);
            }
        }

        return leaving;
    }

    private void Exchange(int leaving, int entering)
    {
        for (var i = 0; i < _unknowns; i++)
        {
            var line = _inverse.AsSpan(i * _unknowns, _unknowns);
            var of = line[leaving] / _shares[leaving];
            for (var b = 0; b < _unknowns; b++)
            {
                line[b] = b == leaving ? of : line[b] - (_shares[b] * of);
            }
        }

        _basis[leaving] = entering;
        SetMultipliers();
    }

    private void SetMultipliers()
    {
        for (var b = 0; b < _unknowns; b++)
        {
            var sum = 0.0;
            for (var i = 0; i < _unknowns; i++)
            {
                sum += _objective[i] * _inverse[(i * _unknowns) + b];
            }

            _multipliers[b] = sum;
        }
    }

    // Gauss and Jordan with the largest pivot. Inverted again for each program, so that rounding does not add up over thousands.
    private void Invert()
    {
        var n = _unknowns;
        Span<double> matrix = stackalloc double[n * n];
        for (var b = 0; b < n; b++)
        {
            _rows.AsSpan(_basis[b] * n, n).CopyTo(matrix[(b * n)..]);
        }

        Array.Clear(_inverse);
        for (var i = 0; i < n; i++)
        {
            _inverse[(i * n) + i] = 1;
        }

        for (var column = 0; column < n; column++)
        {
            var pivot = column;
            for (var i = column + 1; i < n; i++)
            {
                pivot = Math.Abs(matrix[(i * n) + column]) > Math.Abs(matrix[(pivot * n) + column]) ? i : pivot;
            }

            var value = matrix[(pivot * n) + column];
            for (var j = 0; j < n; j++)
            {
                (matrix[(pivot * n) + j], matrix[(column * n) + j]) = (matrix[(column * n) + j], matrix[(pivot * n) + j] / value);
                (_inverse[(pivot * n) + j], _inverse[(column * n) + j]) = (_inverse[(column * n) + j], _inverse[(pivot * n) + j] / value);
            }

            for (var i = 0; i < n; i++)
            {
                var factor = matrix[(i * n) + column];
                if (i == column || factor == 0)
                {
                    continue;
                }

                for (var j = 0; j < n; j++)
                {
                    matrix[(i * n) + j] -= factor * matrix[(column * n) + j];
                    _inverse[(i * n) + j] -= factor * _inverse[(column * n) + j];
                }
            }
        }

        SetMultipliers();
    }
}
