namespace ErrorMatching.Geometry;

/// <content>Knot removal.</content>
internal sealed partial record SplineRows
{
    /// <summary>The closest spline with one knot less: the largest displacement of a pole over the old knots is as small as possible with
    /// fixed ends.</summary>
    /// <remarks>Boehm's insertion of the knot gives the old poles as P = A Q. They have that form if n P = 0 for the single vector n with n
    /// A = 0. The smallest change that achieves this moves the affected poles, except the ends, by n P / sum |n|, each with the sign of its
    /// n.</remarks>
    /// <param name="t">An inner knot of this clamped spline.</param>
    public SplineRows Remove(double t)
    {
        var p = Knots.Degree;
        var times = Knots.Multiplicity(t);
        if (!(t > Knots.Start && t < Knots.End) || times == 0)
        {
            throw new GeometryException(GeometryError.BadKnots, FormattableString.Invariant($"{t} is no inner knot"));
        }

        double[] all = [.. Knots.Values];
        var at = Array.LastIndexOf(all, t);
        var coarse = new KnotVector(p, [.. all[..at], .. all[(at + 1)..]]);

        // Over the coarse knots: t is in the span that starts at knot k, with multiplicity s.
        var (k, s) = (at - 1, times - 1);
        var (first, last) = (k - p, k - s + 1);
        var alpha = new double[last - first + 1];
        alpha[0] = 1;
        for (var i = first + 1; i < last; i++)
        {
            alpha[i - first] = (t - coarse.Values[i]) / (coarse.Values[i + p] - coarse.Values[i]);
        }

        var old = Straighten(first, alpha);
        var values = new double[Values.Length - Width];
        var target = values.AsSpan();
        old.AsSpan(0, (first + 1) * Width).CopyTo(target);
        old.AsSpan(last * Width).CopyTo(target[((last - 1) * Width)..]);

        // From both ends towards the middle, so that no divisor is below one half.
        var middle = first + 1;
        for (; middle < last - 1 && alpha[middle - first] >= 0.5; middle++)
        {
            var a = alpha[middle - first];
            Combine(old, middle, 1 / a, values, middle - 1, (a - 1) / a, target.Slice(middle * Width, Width));
        }

        for (var i = last - 1; i > middle; i--)
        {
            var a = alpha[i - first];
            Combine(old, i, 1 / (1 - a), values, i, -a / (1 - a), target.Slice((i - 1) * Width, Width));
        }

        return new(coarse, values, Width);
    }

    /// <summary>The values with the poles, starting at the first one, moved as little as needed to make the knot redundant.</summary>
    private double[] Straighten(int first, double[] alpha)
    {
        var count = alpha.Length;
        var n = new double[count];
        n[0] = 1;
        for (var i = 1; i < count; i++)
        {
            n[i] = -n[i - 1] * alpha[i - 1] / (1 - alpha[i]);
        }

        // The ends of the spline are fixed.
        var (from, to) = (first == 0 ? 1 : 0, first + count == Knots.PoleCount ? count - 2 : count - 1);
        var sum = 0.0;
        for (var i = from; i <= to; i++)
        {
            sum += Math.Abs(n[i]);
        }

        var values = (double[])Values.Clone();
        for (var c = 0; c < Width; c++)
        {
            var rest = 0.0;
            for (var i = 0; i < count; i++)
            {
                rest += n[i] * Values[((first + i) * Width) + c];
            }

            for (var i = from; i <= to; i++)
            {
                values[((first + i) * Width) + c] -= Math.Sign(n[i]) * rest / sum;
            }
        }

        return values;
    }

    private void Combine(double[] a, int rowA, double factorA, double[] b, int rowB, double factorB, Span<double> target)
    {
        for (var c = 0; c < Width; c++)
        {
            target[c] = (factorA * a[(rowA * Width) + c]) + (factorB * b[(rowB * Width) + c]);
        }
    }
}
