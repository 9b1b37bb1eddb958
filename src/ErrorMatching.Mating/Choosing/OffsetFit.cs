using ErrorMatching.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Mating;

/// <summary>Fits the parameters of an offset to the ways that places of the boundary should go along their normals.</summary>
internal static class OffsetFit
{
    // What keeps a shift small in a direction that no normal has, as a part of the trace.
    private const double Ridge = 1e-9;

    // Lawson's weights converge linearly; after these the largest residual is within a percent of the least possible.
    private const int MostRounds = 60;

    /// <summary>The turn about the origin, then the shift, in the XY plane.</summary>
    public static RigidTransform2 Move(double x, double y, double degrees) => new(Mirror.None, Angle.FromDegrees(degrees), new(x, y));

    /// <summary>Least squares: what the noise of the points asks for.</summary>
    /// <param name="rows">What each parameter does at each place.</param>
    /// <param name="wanted">The way of each place.</param>
    /// <param name="weights">The weight of each place.</param>
    public static double[] LeastSquares(double[][] rows, double[] wanted, double[] weights)
    {
        var count = rows[0].Length;
        var normal = Matrix<double>.Build.Dense(count, count);
        var right = Vector<double>.Build.Dense(count);
        for (var k = 0; k < rows.Length; k++)
        {
            for (var a = 0; a < count; a++)
            {
                right[a] += weights[k] * rows[k][a] * wanted[k];
                for (var b = 0; b < count; b++)
                {
                    normal[a, b] += weights[k] * rows[k][a] * rows[k][b];
                }
            }
        }

        // Each parameter by its own size: a turn moves places by their distance from the origin.
        for (var a = 0; a < count; a++)
        {
            normal[a, a] += (Ridge * Math.Max(normal[a, a], 1e-12)) + 1e-300;
        }

        return [.. normal.Solve(right)];
    }

    /// <summary>The least possible largest residual (C. L. Lawson, 1961: each round weights a place by its residual).</summary>
    /// <param name="rows">What each parameter does at each place.</param>
    /// <param name="wanted">The way of each place.</param>
    public static double[] LeastLargest(double[][] rows, double[] wanted)
    {
        var weights = Enumerable.Repeat(1.0 / rows.Length, rows.Length).ToArray();
        var (best, least) = (new double[rows[0].Length], double.PositiveInfinity);
        for (var round = 0; round < MostRounds; round++)
        {
            var parameters = LeastSquares(rows, wanted, weights);
            var residuals = rows.Select((r, k) => Math.Abs(wanted[k] - Product(r, parameters))).ToArray();
            (best, least) = residuals.Max() < least ? (parameters, residuals.Max()) : (best, least);
            var sum = weights.Zip(residuals, (w, r) => w * r).Sum();
            if (!(sum > 1e-15))
            {
                break;
            }

            weights = [.. weights.Zip(residuals, (w, r) => w * r / sum)];
        }

        return best;
    }

    private static double Product(double[] row, double[] parameters)
    {
        var sum = 0.0;
        for (var i = 0; i < row.Length; i++)
        {
            sum += row[i] * parameters[i];
        }

        return sum;
    }
}
