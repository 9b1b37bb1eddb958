namespace ErrorMatching.Geometry;

/// <summary>The basis functions of a B-spline: how much each pole weighs at a parameter.</summary>
/// <remarks>Piegl and Tiller, The NURBS Book, 2nd edition, chapter 2.</remarks>
/// <param name="degree">Degree of the polynomial pieces.</param>
/// <param name="knots">All knots, repeated by multiplicity.</param>
internal readonly struct BasisFunctions(int degree, double[] knots)
{
    /// <summary>The nonzero basis functions of a piece and their derivatives at a parameter (The NURBS Book, A2.2 and A2.3).</summary>
    /// <param name="span">The piece, from <see cref="KnotVector.SpanAt"/>.</param>
    /// <param name="t">The parameter.</param>
    /// <param name="order">Highest derivative; those above the degree are zero.</param>
    /// <param name="result">(order + 1) rows of degree + 1 numbers: row k has the k-th derivatives for poles span - degree to span.</param>
    public void WithDerivatives(int span, double t, int order, Span<double> result)
    {
        var p = degree;
        var width = p + 1;
        Span<double> triangle = stackalloc double[width * width];
        Span<double> left = stackalloc double[width];
        Span<double> right = stackalloc double[width];
        triangle[0] = 1;
        for (var j = 1; j <= p; j++)
        {
            left[j] = t - knots[span + 1 - j];
            right[j] = knots[span + j] - t;
            var saved = 0.0;
            for (var r = 0; r < j; r++)
            {
                var width2 = right[r + 1] + left[j - r];
                triangle[(j * width) + r] = width2;
                var part = triangle[(r * width) + j - 1] / width2;
                triangle[(r * width) + j] = saved + (right[r + 1] * part);
                saved = left[j - r] * part;
            }

            triangle[(j * width) + j] = saved;
        }

        for (var j = 0; j <= p; j++)
        {
            result[j] = triangle[(j * width) + p];
        }

        if (order > 0)
        {
            Derivatives(triangle, order, result);
        }
    }

    /// <summary>The nonzero basis functions of a piece (The NURBS Book, A2.2).</summary>
    /// <param name="span">The piece, from <see cref="KnotVector.SpanAt"/>.</param>
    /// <param name="t">The parameter.</param>
    /// <param name="values">Receives degree + 1 numbers for poles span - degree to span.</param>
    public void Values(int span, double t, Span<double> values)
    {
        values[0] = 1;
        for (var j = 1; j <= degree; j++)
        {
            var saved = 0.0;
            for (var r = 0; r < j; r++)
            {
                var (right, left) = (knots[span + r + 1], knots[span + 1 - j + r]);
                var part = values[r] / (right - left);
                values[r] = saved + ((right - t) * part);
                saved = (t - left) * part;
            }

            values[j] = saved;
        }
    }

    /// <summary>The nonzero basis functions with first and second derivatives, faster than <see cref="WithDerivatives"/>: the Cox-de Boor
    /// recursion, differentiated by the product rule.</summary>
    /// <param name="span">The piece, from <see cref="KnotVector.SpanAt"/>.</param>
    /// <param name="t">The parameter.</param>
    /// <param name="result">3 rows of degree + 1 numbers: values, first and second derivatives for poles span - degree to span.</param>
    public void WithTwoDerivatives(int span, double t, Span<double> result)
    {
        var p = degree;
        var width = p + 1;
        var values = result[..width];
        var first = result.Slice(width, width);
        var second = result.Slice(2 * width, width);
        values[0] = 1;
        first[0] = second[0] = 0;
        for (var j = 1; j <= p; j++)
        {
            var (saved, savedFirst, savedSecond) = (0.0, 0.0, 0.0);
            for (var r = 0; r < j; r++)
            {
                var (right, left) = (knots[span + r + 1], knots[span + 1 - j + r]);
                var share = 1 / (right - left);
                var (n, d, dd) = (values[r] * share, first[r] * share, second[r] * share);

                values[r] = saved + ((right - t) * n);
                first[r] = savedFirst + ((right - t) * d) - n;
                second[r] = savedSecond + ((right - t) * dd) - (2 * d);
                saved = (t - left) * n;
                savedFirst = ((t - left) * d) + n;
                savedSecond = ((t - left) * dd) + (2 * d);
            }

            (values[j], first[j], second[j]) = (saved, savedFirst, savedSecond);
        }
    }

    /// <summary>Weights of the poles in the polar form (blossom) of one polynomial piece: the point of de Boor's algorithm with a separate
    /// argument in each step. Equal arguments give the basis (Ramshaw, Blossoms are polar forms, Computer Aided Geometric Design 6, 1989,
    /// section 6).</summary>
    /// <param name="span">The piece, from <see cref="KnotVector.SpanAt"/>.</param>
    /// <param name="arguments">As many arguments as the degree.</param>
    /// <param name="weights">Receives degree + 1 weights for poles span - degree to span.</param>
    public void Blossom(int span, ReadOnlySpan<double> arguments, Span<double> weights)
    {
        weights.Clear();
        weights[degree] = 1;
        for (var level = 1; level <= degree; level++)
        {
            // Level k splits the weight of pole i between poles i - 1 and i over the knots i to i + k.
            var x = arguments[level - 1];
            for (var j = degree - level; j < degree; j++)
            {
                var i = span - degree + j + 1;
                var (low, high) = (knots[i], knots[i + level]);
                var weight = weights[j + 1];
                weights[j] += weight * ((high - x) / (high - low));
                weights[j + 1] = weight * ((x - low) / (high - low));
            }
        }
    }

    private void Derivatives(ReadOnlySpan<double> triangle, int order, Span<double> result)
    {
        var p = degree;
        var width = p + 1;
        result[width..((order + 1) * width)].Clear();
        Span<double> a = stackalloc double[2 * width];
        for (var r = 0; r <= p; r++)
        {
            var (s1, s2) = (0, width);
            a[0] = 1;
            for (var k = 1; k <= Math.Min(order, p); k++)
            {
                var d = 0.0;
                var (rk, pk) = (r - k, p - k);
                if (r >= k)
                {
                    a[s2] = a[s1] / triangle[((pk + 1) * width) + rk];
                    d = a[s2] * triangle[(rk * width) + pk];
                }

                var first = rk >= -1 ? 1 : -rk;
                var last = r - 1 <= pk ? k - 1 : p - r;
                for (var j = first; j <= last; j++)
                {
                    a[s2 + j] = (a[s1 + j] - a[s1 + j - 1]) / triangle[((pk + 1) * width) + rk + j];
                    d += a[s2 + j] * triangle[((rk + j) * width) + pk];
                }

                if (r <= pk)
                {
                    a[s2 + k] = -a[s1 + k - 1] / triangle[((pk + 1) * width) + r];
                    d += a[s2 + k] * triangle[(r * width) + pk];
                }

                result[(k * width) + r] = d;
                (s1, s2) = (s2, s1);
            }
        }

        var factor = (double)p;
        for (var k = 1; k <= Math.Min(order, p); k++)
        {
            for (var j = 0; j <= p; j++)
            {
                result[(k * width) + j] *= factor;
            }

            factor *= p - k;
        }
    }
}
