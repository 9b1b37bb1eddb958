using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A B-spline whose poles are rows of numbers, homogeneous if rational: the common form of a curve (a row is a pole) and of one
/// direction of a surface (a row is a line of poles).</summary>
/// <param name="Knots">Degree and knots.</param>
/// <param name="Values">As many rows as the knots require, in sequence.</param>
/// <param name="Width">Numbers in a row.</param>
internal sealed record SplineRows(KnotVector Knots, double[] Values, int Width)
{
    /// <summary>The same spline, or a part of it, over clamped knots of the same degree that contain its own.</summary>
    /// <remarks>Every new pole is the blossom of the old spline at its new knots. With the first piece of its support and ascending order,
    /// all weights are positive, so no digits are lost (Oslo algorithm: Cohen, Lyche and Riesenfeld, Discrete B-splines and subdivision
    /// techniques, Computer Graphics and Image Processing 14, 1980).</remarks>
    public SplineRows Onto(KnotVector finer)
    {
        if (Knots.Equals(finer))
        {
            return this;
        }

        CheckContained(finer);
        var p = Knots.Degree;
        var values = new double[finer.PoleCount * Width];
        Span<double> weights = stackalloc double[p + 1];
        for (var j = 0; j < finer.PoleCount; j++)
        {
            var span = Knots.SpanAt(finer.Values[j]);
            Knots.Basis.Blossom(span, finer.Values.Slice(j + 1, p), weights);
            Add(weights, 1, span, values.AsSpan(j * Width, Width));
        }

        return new(finer, values, Width);
    }

    /// <summary>The same spline with a higher degree, clamped.</summary>
    public SplineRows ElevateTo(int degree)
    {
        var target = Knots.ElevateTo(degree);
        var rows = Onto(Knots.Clamp());
        while (rows.Knots.Degree < degree)
        {
            rows = rows.Elevate();
        }

        return rows with { Knots = target };
    }

    /// <summary>The spline mapped to the range of other knots, with its breaks set to theirs where they differ by rounding only.</summary>
    public SplineRows Snap(KnotVector common)
    {
        var stretched = Knots.Affine(common.Start, common.End);
        var near = KnotVector.SameKnot * (common.End - common.Start);
        var breaks = common.Breaks;
        double[] values = [.. stretched.Values];
        foreach (ref var value in values.AsSpan())
        {
            var at = value;
            value = breaks.Where(b => Math.Abs(b - at) <= near).Append(at).First();
        }

        return this with { Knots = new(Knots.Degree, values) };
    }

    public double[] RowAt(double t)
    {
        var p = Knots.Degree;
        var span = Knots.SpanAt(t);
        Span<double> basis = stackalloc double[p + 1];
        Knots.Basis.WithDerivatives(span, t, 0, basis);
        var row = new double[Width];
        Add(basis, 1, span, row);
        return row;
    }

    public SplineRows Reverse()
    {
        var values = new double[Values.Length];
        for (var i = 0; i < Knots.PoleCount; i++)
        {
            Values.AsSpan(i * Width, Width).CopyTo(values.AsSpan(values.Length - ((i + 1) * Width), Width));
        }

        return new(Knots.Reverse(), values, Width);
    }

    /// <summary>Raises the degree by one. The blossom of degree p + 1 is the mean of the blossoms of degree p with one argument left out.
    /// It is evaluated in the longest piece of the new pole's support, so that no argument is far outside (Ramshaw, as above; Prautzsch,
    /// Degree elevation of B-spline curves, Computer Aided Geometric Design 1, 1984).</summary>
    private SplineRows Elevate()
    {
        var p = Knots.Degree;
        var target = Knots.ElevateTo(p + 1);
        var values = new double[target.PoleCount * Width];
        Span<double> weights = stackalloc double[p + 1];
        Span<double> arguments = stackalloc double[p];
        for (var j = 0; j < target.PoleCount; j++)
        {
            var span = LongestPiece(target.Values[j], target.Values[j + p + 2]);
            for (var left = 0; left <= p; left++)
            {
                for (var k = 0; k < p; k++)
                {
                    arguments[k] = target.Values[j + 1 + (k < left ? k : k + 1)];
                }

                Knots.Basis.Blossom(span, arguments, weights);
                Add(weights, 1.0 / (p + 1), span, values.AsSpan(j * Width, Width));
            }
        }

        return new(target, values, Width);
    }

    private int LongestPiece(double from, double to)
    {
        var best = Knots.SpanAt(from);
        for (var i = best + 1; i < Knots.PoleCount && Knots.Values[i + 1] <= to; i++)
        {
            best = Knots.Values[i + 1] - Knots.Values[i] > Knots.Values[best + 1] - Knots.Values[best] ? i : best;
        }

        return best;
    }

    private void Add(ReadOnlySpan<double> weights, double factor, int span, Span<double> row)
    {
        for (var k = 0; k < weights.Length; k++)
        {
            var weight = weights[k] * factor;
            if (weight == 0)
            {
                continue;
            }

            var source = Values.AsSpan((span - Knots.Degree + k) * Width, Width);
            for (var c = 0; c < row.Length; c++)
            {
                row[c] += weight * source[c];
            }
        }
    }

    private void CheckContained(KnotVector finer)
    {
        var (start, end) = (finer.Start, finer.End);
        if (finer.Degree != Knots.Degree || !finer.IsClamped || start < Knots.Start || end > Knots.End)
        {
            throw new GeometryException(
                GeometryError.BadKnots, "the new knots are not clamped, of another degree, or reach beyond the spline's range");
        }

        foreach (var value in Knots.Breaks)
        {
            if (value > start && value < end && finer.Multiplicity(value) < Knots.Multiplicity(value))
            {
                throw new GeometryException(
                    GeometryError.BadKnots,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"the new knots have {value} {finer.Multiplicity(value)} times; the spline has it {Knots.Multiplicity(value)} "
                            + $"times"));
            }
        }
    }

    // Knot removal.

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
