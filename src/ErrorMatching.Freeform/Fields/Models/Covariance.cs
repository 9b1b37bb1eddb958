namespace ErrorMatching.Freeform;

/// <summary>The covariance matrix K of a kernel at the values, with noise on its diagonal.</summary>
internal abstract class Covariance
{
    /// <summary>Maximum number of values off a grid: the full matrix takes n^3 / 3 steps to factor.</summary>
    public const int MostScattered = 300;

    /// <summary>Maximum number of grid lines in one direction for an eigendecomposition.</summary>
    public const int MostLines = 150;

    public abstract double LogDeterminant { get; }

    public abstract double InverseTrace { get; }

    /// <summary>True if there are few values, or a grid with few enough lines.</summary>
    public static bool IsPossible(FieldData data) =>
        data.Count <= MostScattered || (data.Grid is { } grid && grid.U.Length <= MostLines && grid.V.Length <= MostLines);

    /// <summary>Builds the matrix; null if it is not positive definite in double precision.</summary>
    /// <param name="data">The values.</param>
    /// <param name="kernel">The kernel.</param>
    /// <param name="like">The matrix of the same kernel over other values that may share some lines; null if there is none.</param>
    public static Covariance? Of(FieldData data, Kernel kernel, Covariance? like = null) =>
        data.Grid is { } grid ? new GridCovariance(grid, kernel, like as GridCovariance) : ScatteredCovariance.Full(data, kernel);

    /// <summary>The solution x of K x = b.</summary>
    public abstract double[] Solve(double[] b);

    /// <summary>Number of vectors of the basis that the kernel between a place and the values may have a part of; the first ones. The parts
    /// of all others are below rounding.</summary>
    public abstract int Leading { get; }

    /// <summary>Converts one number per value to the orthonormal basis in which systems with many places are solved fastest. Products of
    /// two converted lists are those of the lists.</summary>
    public abstract double[] ToBasis(double[] b);

    /// <summary>The kernel between a place and each value: its leading parts in that basis.</summary>
    public abstract double[] RowInBasis(double u, double v);

    /// <summary>The solution x of K x = b, both as leading parts in that basis.</summary>
    public abstract double[] SolveInBasis(double[] b);

    /// <summary>The sum of the kernel between a place and each value, with weights in that basis.</summary>
    public abstract double Sum(double u, double v, double[] weights);
}
