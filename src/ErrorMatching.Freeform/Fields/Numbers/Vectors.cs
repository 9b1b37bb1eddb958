using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace ErrorMatching.Freeform;

/// <summary>Linear algebra on rows of numbers, four numbers at a time. The order of summation is fixed, so that every processor gives the
/// same sums.</summary>
internal static class Vectors
{
    /// <summary>Numbers in one vector of a processor.</summary>
    public const int Width = 4;

    public static double Dot(ReadOnlySpan<double> a, ReadOnlySpan<double> b)
    {
        ref var x = ref MemoryMarshal.GetReference(a);
        ref var y = ref MemoryMarshal.GetReference(b[..a.Length]);
        var sums = Vector256<double>.Zero;
        var k = 0;
        for (; k + Width <= a.Length; k += Width)
        {
            sums += Vector256.LoadUnsafe(ref x, (nuint)k) * Vector256.LoadUnsafe(ref y, (nuint)k);
        }

        return Rest(sums, a, b, k);
    }

    /// <summary>The dot products of one vector with two others, each summed as by <see cref="Dot"/>. Two sums at once do not wait for each
    /// other.</summary>
    public static (double WithFirst, double WithSecond) Dots(
        ReadOnlySpan<double> a, ReadOnlySpan<double> first, ReadOnlySpan<double> second)
    {
        ref var x = ref MemoryMarshal.GetReference(a);
        ref var p = ref MemoryMarshal.GetReference(first[..a.Length]);
        ref var q = ref MemoryMarshal.GetReference(second[..a.Length]);
        var (sumP, sumQ) = (Vector256<double>.Zero, Vector256<double>.Zero);
        var k = 0;
        for (; k + Width <= a.Length; k += Width)
        {
            var value = Vector256.LoadUnsafe(ref x, (nuint)k);
            sumP += value * Vector256.LoadUnsafe(ref p, (nuint)k);
            sumQ += value * Vector256.LoadUnsafe(ref q, (nuint)k);
        }

        return (Rest(sumP, a, first, k), Rest(sumQ, a, second, k));
    }

    /// <summary>Forward substitution of the last four numbers of a row: number m becomes (itself - dot product of those before it with row
    /// m) / last number of row m. Each dot product is summed as by <see cref="Dot"/>.</summary>
    /// <remarks>Four sums at once do not wait for each other, as the additions of one sum do.</remarks>
    /// <param name="row">The row; all but its last four numbers are done.</param>
    /// <param name="a">The row that the first of them needs: as many numbers as are before it, and its divisor.</param>
    /// <param name="b">The row that the second of them needs, one longer.</param>
    /// <param name="c">The same for the third.</param>
    /// <param name="d">The same for the last.</param>
    public static void Substitute(
        Span<double> row, ReadOnlySpan<double> a, ReadOnlySpan<double> b, ReadOnlySpan<double> c, ReadOnlySpan<double> d)
    {
        var done = row.Length - Width;
        ref var x = ref MemoryMarshal.GetReference(row);
        ref var p = ref MemoryMarshal.GetReference(a[..done]);
        ref var q = ref MemoryMarshal.GetReference(b[..done]);
        ref var r = ref MemoryMarshal.GetReference(c[..done]);
        ref var s = ref MemoryMarshal.GetReference(d[..done]);
        var (sumA, sumB, sumC, sumD) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
        var k = 0;
        for (; k + Width <= done; k += Width)
        {
            var value = Vector256.LoadUnsafe(ref x, (nuint)k);
            sumA += value * Vector256.LoadUnsafe(ref p, (nuint)k);
            sumB += value * Vector256.LoadUnsafe(ref q, (nuint)k);
            sumC += value * Vector256.LoadUnsafe(ref r, (nuint)k);
            sumD += value * Vector256.LoadUnsafe(ref s, (nuint)k);
        }

        Last(row[..(done + 1)], sumA, a, k);
        Last(row[..(done + 2)], sumB, b, k);
        Last(row[..(done + 3)], sumC, c, k);
        Last(row, sumD, d, k);

        static void Last(Span<double> row, Vector256<double> sums, ReadOnlySpan<double> other, int summed)
        {
            var before = row[..^1];
            if (summed + Width <= before.Length)
            {
                sums += Vector256.Create<double>(before[summed..]) * Vector256.Create(other[summed..]);
                summed += Width;
            }

            row[^1] = (row[^1] - Rest(sums, before, other, summed)) / other[before.Length];
        }
    }

    private static double Rest(Vector256<double> sums, ReadOnlySpan<double> a, ReadOnlySpan<double> b, int k)
    {
        var sum = sums[0] + sums[1] + (sums[2] + sums[3]);
        for (; k < a.Length; k++)
        {
            sum += a[k] * b[k];
        }

        return sum;
    }

    public static double[] Products(ReadOnlySpan<double> a, ReadOnlySpan<double> b)
    {
        var result = new double[a.Length];
        for (var k = 0; k < result.Length; k++)
        {
            result[k] = a[k] * b[k];
        }

        return result;
    }

    /// <summary>Rotates two vectors in their plane: p becomes cosine p + sine q, q becomes cosine q - sine p.</summary>
    public static void Rotate(Span<double> p, Span<double> q, double cosine, double sine)
    {
        ref var x = ref MemoryMarshal.GetReference(p);
        ref var y = ref MemoryMarshal.GetReference(q[..p.Length]);
        var k = 0;
        for (; k + Width <= p.Length; k += Width)
        {
            var (a, b) = (Vector256.LoadUnsafe(ref x, (nuint)k), Vector256.LoadUnsafe(ref y, (nuint)k));
            ((a * cosine) + (b * sine)).StoreUnsafe(ref x, (nuint)k);
            ((b * cosine) - (a * sine)).StoreUnsafe(ref y, (nuint)k);
        }

        for (; k < p.Length; k++)
        {
            (p[k], q[k]) = ((cosine * p[k]) + (sine * q[k]), (cosine * q[k]) - (sine * p[k]));
        }
    }

    public static void Subtract(Span<double> from, double multiple, ReadOnlySpan<double> vector)
    {
        ref var x = ref MemoryMarshal.GetReference(from);
        ref var y = ref MemoryMarshal.GetReference(vector[..from.Length]);
        var k = 0;
        for (; k + Width <= from.Length; k += Width)
        {
            (Vector256.LoadUnsafe(ref x, (nuint)k) - (Vector256.LoadUnsafe(ref y, (nuint)k) * multiple)).StoreUnsafe(ref x, (nuint)k);
        }

        for (; k < from.Length; k++)
        {
            from[k] -= multiple * vector[k];
        }
    }
}
