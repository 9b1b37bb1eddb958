namespace ErrorMatching.Freeform;

/// <summary>The matrix K of a kernel over the places of values, noise on its diagonal.</summary>
internal abstract class Covariance
{
    /// <summary>Values without a grid up to which the full matrix is made: its factor takes n^3 / 3 steps.</summary>
    public const int MostScattered = 300;

    /// <summary>Lines of a grid in one direction up to which its matrix is decomposed.</summary>
    public const int MostLines = 150;

    public abstract double LogDeterminant { get; }

    /// <summary>Trace of the inverse.</summary>
    public abstract double InverseTrace { get; }

    /// <summary>True if the values are few, or form a grid of not too many lines.</summary>
    public static bool IsPossible(FieldData data) =>
        data.Count <= MostScattered || (data.Grid is { } grid && grid.U.Length <= MostLines && grid.V.Length <= MostLines);

    /// <summary>The matrix; null if it is not positive definite in double precision.</summary>
    /// <param name="data">The values.</param>
    /// <param name="kernel">The kernel.</param>
    /// <param name="like">The matrix of the same kernel over other values, some of whose lines may be the same; null if there is none.</param>
    public static Covariance? Of(FieldData data, Kernel kernel, Covariance? like = null) =>
        data.Grid is { } grid ? new GridCovariance(grid, kernel, like as GridCovariance) : ScatteredCovariance.Full(data, kernel);

    /// <summary>The solution x of K x = b.</summary>
    public abstract double[] Solve(double[] b);

    /// <summary>The kernel between a place and each value.</summary>
    public abstract double[] Row(double u, double v);

    /// <summary>The sum of the kernel between a place and each value, times a weight each.</summary>
    public abstract double Sum(double u, double v, double[] weights);
}
