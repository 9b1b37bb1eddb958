namespace ErrorMatching.Freeform.Tests;

/// <summary>The variance of a process against the equations of universal kriging (Cressie, Statistics for Spatial Data, 1993, section
/// 3.4), written out and solved by elimination.</summary>
public sealed class ProcessVarianceTests
{
    private static readonly Kernel Kernel = new(0.8, 1.1, 0.05);
    private static readonly Term[] Trend = [new(new(0), new(0)), new(new(1), new(0)), new(new(0), new(1))];

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Variance_is_that_of_the_kriging_equations(bool onGrid)
    {
        var data = Data(onGrid);
        Assert.Equal(onGrid, data.Grid is not null);
        var model = ProcessModel.Fit(ProcessTrend.Of(data, Trend), Kernel)!;
        var process = model.Noise * model.Noise / Kernel.Noise;
        foreach (var (u, v) in new[] { (0.13, -0.4), (data.U[5], data.V[5]), (1, -1), (-0.77, 0.9) })
        {
            var (missing, weights) = Kriging(data, u, v);
            var squares = weights.Sum(w => w * w);

            Assert.Equal(weights.Zip(data.Z, (w, z) => w * z).Sum(), model.At(u, v), 1e-11);
            Assert.Equal(process * missing, model.VarianceAt(u, v, 0), 1e-10 * process);

            // Noise beyond that of the model comes on top, by the squares of the weights.
            var noise = 2 * model.Noise;
            Assert.Equal((process * missing) + (3 * model.Noise * model.Noise * squares), model.VarianceAt(u, v, noise), 1e-10 * process);
        }
    }

    // 7 by 6 values, in mixed order; without the last one they are no grid.
    private static FieldData Data(bool onGrid)
    {
        var noise = new Noise(3);
        var order = Enumerable.Range(0, 42).OrderBy(k => k * 17 % 43).Take(onGrid ? 42 : 41).ToArray();
        int[] i = [.. order.Select(k => k % 7)], j = [.. order.Select(k => k / 7)];
        double[] u = [.. i.Select(x => -1 + (x / 3.0))], v = [.. j.Select(x => -1 + (x / 2.5))];
        return new(i, j, u, v, [.. u.Zip(v, (a, b) => Math.Sin(2 * a) + (a * b) + (0.1 * noise.Next()))]);
    }

    // The variance of the estimate as a share of that of the process, and the weights of the values.
    private static (double Missing, double[] Weights) Kriging(FieldData data, double u, double v)
    {
        var n = data.Count;
        var size = n + Trend.Length;
        var rows = new double[size][];
        for (var r = 0; r < size; r++)
        {
            rows[r] = new double[size + 1];
            for (var c = 0; c < size; c++)
            {
                rows[r][c] = r < n && c < n ? Correlation(data.U[r] - data.U[c], data.V[r] - data.V[c]) + (r == c ? Kernel.Noise : 0)
                    : r < n ? Trend[c - n].At(data.U[r], data.V[r])
                    : c < n ? Trend[r - n].At(data.U[c], data.V[c])
                    : 0;
            }

            rows[r][size] = r < n ? Correlation(u - data.U[r], v - data.V[r]) : Trend[r - n].At(u, v);
        }

        var right = rows.Select(r => r[size]).ToArray();
        var solution = Eliminated(rows);
        return (1 - solution.Zip(right, (x, b) => x * b).Sum(), solution[..n]);
    }

    private static double Correlation(double du, double dv) =>
        Math.Exp(-((du * du / 0.64) + (dv * dv / 1.21)) / 2);

    private static double[] Eliminated(double[][] rows)
    {
        var n = rows.Length;
        for (var c = 0; c < n; c++)
        {
            var pivot = Enumerable.Range(c, n - c).MaxBy(r => Math.Abs(rows[r][c]));
            (rows[c], rows[pivot]) = (rows[pivot], rows[c]);
            for (var r = 0; r < n; r++)
            {
                var factor = r == c ? 0 : rows[r][c] / rows[c][c];
                for (var k = c; k <= n; k++)
                {
                    rows[r][k] -= factor * rows[c][k];
                }
            }
        }

        return [.. rows.Select((r, k) => r[n] / r[k])];
    }
}
