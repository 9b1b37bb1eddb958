namespace ErrorMatching.Geometry;

/// <summary>The poles of a surface as rows of numbers, homogeneous if rational: the poles of splines along u and along v.</summary>
/// <param name="U">Degree and knots along u.</param>
/// <param name="V">Degree and knots along v.</param>
/// <param name="Values">The numbers of all poles, v varying fastest.</param>
/// <param name="Size">Numbers per pole.</param>
internal sealed record SurfaceRows(KnotVector U, KnotVector V, double[] Values, int Size)
{
    /// <summary>The splines along u: a row is a line of poles.</summary>
    public SplineRows AlongU() => new(U, Values, V.PoleCount * Size);

    /// <summary>The splines along v.</summary>
    public SplineRows AlongV() => Swap().AlongU();

    /// <summary>The rows with u and v exchanged.</summary>
    public SurfaceRows Swap() => new(V, U, Transpose(Values, U.PoleCount, V.PoleCount, Size), Size);

    /// <summary>The rows after separate operations on the splines along u and along v.</summary>
    public SurfaceRows Each(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV)
    {
        var first = alongU(AlongU());
        var countU = first.Knots.PoleCount;
        var second = alongV(new(V, Transpose(first.Values, countU, V.PoleCount, Size), countU * Size));
        return new(first.Knots, second.Knots, Transpose(second.Values, second.Knots.PoleCount, countU, Size), Size);
    }

    private static double[] Transpose(double[] values, int rows, int columns, int size)
    {
        var turned = new double[values.Length];
        for (var i = 0; i < rows; i++)
        {
            for (var j = 0; j < columns; j++)
            {
                values.AsSpan(((i * columns) + j) * size, size).CopyTo(turned.AsSpan(((j * rows) + i) * size, size));
            }
        }

        return turned;
    }
}
