namespace ErrorMatching.Mating.Tests;

/// <summary>
/// A Gaussian process over a length, as the textbook has it (Rasmussen and Williams 2006, sections 2.2, 2.7 and 5.4.1): squared exponential
/// kernel, linear mean without a prior, known noise, amplitude and length where the restricted likelihood is largest on a fine grid. Shares
/// no code with what it judges.
/// </summary>
internal sealed class ReferenceProcess
{
    private readonly double[] _along;
    private readonly double[] _weights;
    private readonly double[] _line;
    private readonly (double Amplitude, double Length) _kernel;

    private ReferenceProcess(double[] along, (double Amplitude, double Length) kernel, double[] weights, double[] line) =>
        (_along, _kernel, _weights, _line) = (along, kernel, weights, line);

    public static ReferenceProcess Of(double[] along, double[] values, double noise)
    {
        var (span, scatter) = (along[^1] - along[0], values.Max() - values.Min());
        var (best, chosen) = (double.NegativeInfinity, (ReferenceProcess?)null);
        for (var i = 0; i < 24; i++)
        {
            for (var j = 0; j < 24; j++)
            {
                var kernel = (0.3 * noise * Math.Pow(10 * scatter / noise, i / 23.0), 0.05 * span * Math.Pow(60, j / 23.0));
                var (process, log) = Fit(along, values, noise, kernel);
                (best, chosen) = log > best ? (log, process) : (best, chosen);
            }
        }

        return chosen!;
    }

    /// <summary>The mean of processes of many scales, weighed by how likely they make the values.</summary>
    public static Func<double, double> Mean(
        double[] along, double[] values, double noise, (double Amplitude, double Length)[] kernels)
    {
        var fits = kernels.Select(k => Fit(along, values, noise, k)).ToArray();
        var top = fits.Max(f => f.Log);
        double[] weights = [.. fits.Select(f => Math.Exp(f.Log - top))];
        return place => fits.Zip(weights, (f, w) => w * f.Process.At(place)).Sum() / weights.Sum();
    }

    /// <summary>The process with scales that are given.</summary>
    public static ReferenceProcess Told(double[] along, double[] values, double noise, (double Amplitude, double Length) kernel) =>
        Fit(along, values, noise, kernel).Process;

    /// <summary>A curve that the kernel makes likely, at some places: the lower factor of their covariance times normal numbers.</summary>
    public static double[] Draw(double[] places, (double Amplitude, double Length) kernel, Func<double> normal)
    {
        var n = places.Length;
        var (factor, drawn) = (new double[n, n], new double[n]);
        double[] normals = [.. places.Select(_ => normal())];
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j <= i; j++)
            {
                var sum = Kernel(kernel, places[i] - places[j]) + (i == j ? 1e-9 * kernel.Amplitude * kernel.Amplitude : 0);
                for (var k = 0; k < j; k++)
                {
                    sum -= factor[i, k] * factor[j, k];
                }

                factor[i, j] = i == j ? Math.Sqrt(sum) : sum / factor[j, j];
                drawn[i] += factor[i, j] * normals[j];
            }
        }

        return drawn;
    }

    public double At(double place) =>
        _line[0] + (_line[1] * place) + _along.Select((s, i) => _weights[i] * Kernel(_kernel, place - s)).Sum();

    // Generalized least squares for the line; the likelihood of what remains.
    private static (ReferenceProcess Process, double Log) Fit(
        double[] along, double[] values, double noise, (double Amplitude, double Length) kernel)
    {
        var n = along.Length;
        var c = new double[n, n];
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j < n; j++)
            {
                c[i, j] = Kernel(kernel, along[i] - along[j]) + (i == j ? noise * noise : 0);
            }
        }

        var (columns, logDeterminant) = Solve(c, [[.. along.Select(_ => 1.0)], along, values]);
        var (a, b, d) = (columns[0].Sum(), Dot(along, columns[0]), Dot(along, columns[1]));
        var (e, f) = (columns[2].Sum(), Dot(along, columns[2]));
        var determinant = (a * d) - (b * b);
        double[] line = [((d * e) - (b * f)) / determinant, ((a * f) - (b * e)) / determinant];
        double[] weights = [.. columns[2].Select((w, i) => w - (line[0] * columns[0][i]) - (line[1] * columns[1][i]))];
        return (new(along, kernel, weights, line), -(Dot(values, weights) + logDeterminant + Math.Log(determinant)) / 2);
    }

    // Gaussian elimination of a positive definite matrix.
    private static (double[][] Columns, double LogDeterminant) Solve(double[,] matrix, double[][] right)
    {
        var n = matrix.GetLength(0);
        double[][] columns = [.. right.Select(r => r.ToArray())];
        var log = 0.0;
        for (var k = 0; k < n; k++)
        {
            log += Math.Log(matrix[k, k]);
            for (var i = k + 1; i < n; i++)
            {
                var factor = matrix[i, k] / matrix[k, k];
                for (var j = k; j < n; j++)
                {
                    matrix[i, j] -= factor * matrix[k, j];
                }

                Array.ForEach(columns, c => c[i] -= factor * c[k]);
            }
        }

        foreach (var column in columns)
        {
            for (var i = n - 1; i >= 0; i--)
            {
                for (var j = i + 1; j < n; j++)
                {
                    column[i] -= matrix[i, j] * column[j];
                }

                column[i] /= matrix[i, i];
            }
        }

        return (columns, log);
    }

    private static double Kernel((double Amplitude, double Length) kernel, double distance) =>
        kernel.Amplitude * kernel.Amplitude * Math.Exp(-(distance * distance) / (2 * kernel.Length * kernel.Length));

    private static double Dot(double[] a, double[] b) => a.Zip(b, (x, y) => x * y).Sum();
}
