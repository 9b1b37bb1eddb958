namespace ErrorMatching.Geometry;

/// <summary>The factored equations for a B-spline with given values at the Greville parameters of its poles. The matrix is banded and
/// totally positive, so elimination without pivoting is stable (de Boor and Pinkus, Backward error analysis for totally positive linear
/// systems, Numerische Mathematik 27, 1977).</summary>
internal sealed class GrevilleSystem
{
    private readonly int _count;
    private readonly int _band;

    // Row i contains columns i - band to i + band.
    private readonly double[] _rows;

    public GrevilleSystem(KnotVector knots)
    {
        (_count, _band) = (knots.PoleCount, knots.Degree);
        _rows = new double[_count * Width];
        Span<double> basis = stackalloc double[knots.Degree + 1];
        for (var i = 0; i < _count; i++)
        {
            var t = knots.Greville(i);
            if (i > 0 && !(t > knots.Greville(i - 1)))
            {
                throw new GeometryException(
                    GeometryError.BadKnots,
                    FormattableString.Invariant(
                        $"the knot {t} is repeated more than {knots.Degree} times; a curve through points cannot jump"));
            }

            var span = knots.SpanAt(t);
            knots.Basis.WithDerivatives(span, t, 0, basis);
            for (var k = 0; k <= knots.Degree; k++)
            {
                var column = span - knots.Degree + k;
                if (Math.Abs(column - i) <= _band)
                {
                    At(i, column) = basis[k];
                }
            }
        }

        Factor();
    }

    private int Width => (2 * _band) + 1;

    /// <summary>Replaces values by poles.</summary>
    /// <param name="values">One row per pole.</param>
    /// <param name="width">Numbers in a row.</param>
    public void Solve(double[] values, int width)
    {
        for (var i = 0; i < _count; i++)
        {
            for (var k = Math.Max(0, i - _band); k < i; k++)
            {
                Subtract(values, i, k, At(i, k), width);
            }
        }

        for (var i = _count - 1; i >= 0; i--)
        {
            for (var k = i + 1; k <= Math.Min(_count - 1, i + _band); k++)
            {
                Subtract(values, i, k, At(i, k), width);
            }

            foreach (ref var x in values.AsSpan(i * width, width))
            {
                x /= At(i, i);
            }
        }
    }

    private static void Subtract(double[] values, int row, int from, double factor, int width)
    {
        if (factor == 0)
        {
            return;
        }

        var target = values.AsSpan(row * width, width);
        var source = values.AsSpan(from * width, width);
        for (var c = 0; c < width; c++)
        {
            target[c] -= factor * source[c];
        }
    }

    private void Factor()
    {
        for (var k = 0; k < _count; k++)
        {
            for (var i = k + 1; i <= Math.Min(_count - 1, k + _band); i++)
            {
                var factor = At(i, k) / At(k, k);
                At(i, k) = factor;
                for (var j = k + 1; j <= Math.Min(_count - 1, k + _band) && factor != 0; j++)
                {
                    At(i, j) -= factor * At(k, j);
                }
            }
        }
    }

    private ref double At(int row, int column) => ref _rows[(row * Width) + column - row + _band];
}
