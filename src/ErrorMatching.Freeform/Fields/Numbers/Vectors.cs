using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace ErrorMatching.Freeform;

/// <summary>Linear algebra on rows of numbers, four numbers at a time. The order of summation is fixed, so that every processor gives the
/// same sums.</summary>
internal static class Vectors
{
    private const int Width = 4;

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
