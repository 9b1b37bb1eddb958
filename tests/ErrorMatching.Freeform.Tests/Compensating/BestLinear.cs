namespace ErrorMatching.Freeform.Tests;

/// <summary>The best linear prediction of a family of errors from noisy values: it knows the covariance, from many draws, and the
/// noise (Rasmussen and Williams, Gaussian Processes for Machine Learning, equation 2.23). No linear fit leaves less on average.</summary>
internal sealed class BestLinear
{
    private const int Draws = 1500;

    // The mean is not known: its variance is far above everything else.
    private const double VagueMean = 1e-4;

    private readonly double[][] _atPoints;
    private readonly double[][] _even;

    public BestLinear(DrawnError family, IReadOnlyList<(double X, double Y)> points, double noise, double deviation)
    {
        var (here, there) = (new double[Draws][], new double[Draws][]);
        for (var k = 0; k < Draws; k++)
        {
            var draw = family.Of(900_000 + k, deviation);
            here[k] = [.. points.Select(p => draw(p.X, p.Y))];
            there[k] = [.. DrawnError.Even.Select(p => draw(p.X, p.Y))];
        }

        var covariance = Products(here, here);
        var rows = Enumerable.Range(0, points.Count).Select(i => covariance[i][..(i + 1)]).ToArray();
        for (var i = 0; i < rows.Length; i++)
        {
            rows[i][i] += noise * noise;
        }

        var factor = BandedCholesky.Factor(rows, rows.Length)!;
        _atPoints = Array.ConvertAll(covariance, factor.Solve);
        _even = Array.ConvertAll(Products(there, here), factor.Solve);
    }

    /// <summary>The predictions at the points and on the even grid.</summary>
    public (double[] AtPoints, double[] Even) Of(double[] values) => (
        Array.ConvertAll(_atPoints, w => Vectors.Dot(w, values)), Array.ConvertAll(_even, w => Vectors.Dot(w, values)));

    private static double[][] Products(double[][] left, double[][] right)
    {
        var result = Array.ConvertAll(left[0], _ => Enumerable.Repeat(VagueMean, right[0].Length).ToArray());
        for (var k = 0; k < Draws; k++)
        {
            for (var i = 0; i < result.Length; i++)
            {
                Vectors.Subtract(result[i], -left[k][i] / Draws, right[k]);
            }
        }

        return result;
    }
}
