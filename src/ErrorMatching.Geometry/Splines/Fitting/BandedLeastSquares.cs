namespace ErrorMatching.Geometry;

/// <summary>Least squares for equations with a few neighboring unknowns each, for several right-hand sides. Givens rotations reduce every
/// new equation into a banded triangle, which avoids the loss of half the digits in normal equations (M. G. Cox, "The least-squares
/// solution of overdetermined linear equations having band or augmented band structure", IMA J. Numer. Anal. 1, 1981).</summary>
/// <remarks>Equations are cheap in the order of their first unknown. As many independent equations as unknowns are solved exactly, so
/// interpolation needs no separate solver.</remarks>
internal sealed class BandedLeastSquares
{
    private readonly double[] _triangle;
    private readonly double[] _rights;
    private readonly bool[] _filled;
    private readonly int _unknowns;
    private readonly int _width;
    private readonly int _columns;

    /// <summary>Starts without equations.</summary>
    /// <param name="unknowns">Number of unknowns per right-hand side.</param>
    /// <param name="width">Maximum number of neighboring unknowns in an equation.</param>
    /// <param name="columns">Number of right-hand sides.</param>
    public BandedLeastSquares(int unknowns, int width, int columns)
    {
        (_unknowns, _width, _columns) = (unknowns, Math.Min(width, unknowns), columns);
        _triangle = new double[unknowns * _width];
        _rights = new double[unknowns * columns];
        _filled = new bool[unknowns];
    }

    /// <summary>Adds an equation.</summary>
    /// <param name="first">Index of its first unknown.</param>
    /// <param name="factors">Factors of that unknown and the following ones; overwritten.</param>
    /// <param name="rights">One number per right-hand side; overwritten.</param>
    public void Add(int first, Span<double> factors, Span<double> rights)
    {
        for (var row = first; row < _unknowns; row++)
        {
            var pivot = factors[0];
            var band = _triangle.AsSpan(row * _width, Math.Min(_width, _unknowns - row));
            var right = _rights.AsSpan(row * _columns, _columns);
            if (!_filled[row])
            {
                if (pivot != 0)
                {
                    factors[..Math.Min(factors.Length, band.Length)].CopyTo(band);
                    rights.CopyTo(right);
                    _filled[row] = true;
                    return;
                }
            }
            else if (pivot != 0)
            {
                var length = double.Hypot(band[0], pivot);
                var (c, s) = (band[0] / length, pivot / length);
                Rotate(c, s, band, factors);
                Rotate(c, s, right, rights);
            }

            factors[1..].CopyTo(factors);
            factors[^1] = 0;
        }
    }

    /// <summary>The unknowns, right-hand sides varying fastest.</summary>
    /// <exception cref="GeometryException">The equations do not determine them (<see cref="GeometryError.RankDeficient"/>).</exception>
    public double[] Solve()
    {
        var largest = 0.0;
        for (var row = 0; row < _unknowns; row++)
        {
            largest = Math.Max(largest, Math.Abs(_triangle[row * _width]));
        }

        for (var row = _unknowns - 1; row >= 0; row--)
        {
            var diagonal = _triangle[row * _width];
            if (!(Math.Abs(diagonal) > 1e-14 * largest))
            {
                throw new GeometryException(
                    GeometryError.RankDeficient,
                    $"the points do not determine pole {row + 1} of {_unknowns}: take fewer poles or a lower degree");
            }

            var right = _rights.AsSpan(row * _columns, _columns);
            for (var k = 1; k < Math.Min(_width, _unknowns - row); k++)
            {
                var factor = _triangle[(row * _width) + k];
                var known = _rights.AsSpan((row + k) * _columns, _columns);
                for (var i = 0; i < right.Length; i++)
                {
                    right[i] -= factor * known[i];
                }
            }

            for (var i = 0; i < right.Length; i++)
            {
                right[i] /= diagonal;
            }
        }

        return _rights;
    }

    private static void Rotate(double c, double s, Span<double> a, Span<double> b)
    {
        var count = Math.Min(a.Length, b.Length);
        for (var i = 0; i < count; i++)
        {
            (a[i], b[i]) = ((c * a[i]) + (s * b[i]), (c * b[i]) - (s * a[i]));
        }
    }
}
