using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Waves over values at places: the products of cosine and sine along u and along v, for a grid of frequencies.</summary>
/// <remarks>A Lomb-Scargle periodogram in two directions (J. D. Scargle, Astrophysical Journal 263, 1982): for each pair of frequencies the
/// share of the variance that its functions explain. Half waves over the range are the longest, two spacings are the shortest. On a grid,
/// values are summed along u first and along v then, which is a tenth of the work. It keeps these sums, so each thread needs its own.
/// </remarks>
internal sealed class WaveBasis
{
    /// <summary>Largest number of frequencies along one direction.</summary>
    private const int MostFrequencies = 9;

    private readonly SampleGrid? _grid;
    private readonly int _count;
    private readonly Wave[] _waves;

    // Cosine and sine of each frequency, in turn: at the lines of the grid, or at each value.
    private readonly double[][] _alongU;
    private readonly double[][] _alongV;

    // On a grid: the values in its order, and their sums along u with each function.
    private readonly double[] _values;
    private readonly double[][] _sums;

    private WaveBasis(FieldData data)
    {
        (_grid, _count) = (data.Grid, data.Count);
        var (frequenciesU, frequenciesV) = (Frequencies(data.Crossings.Length), Frequencies(data.Curves.Length));
        _alongU = Functions(_grid?.U ?? data.U, frequenciesU);
        _alongV = Functions(_grid?.V ?? data.V, frequenciesV);
        _values = new double[_grid is null ? 0 : _count];
        _sums = Array.ConvertAll(_alongU, _ => new double[_grid?.V.Length ?? 0]);
        var waves = new List<Wave>();
        for (var u = 0; u < frequenciesU.Length; u++)
        {
            for (var v = 0; v < frequenciesV.Length; v++)
            {
                var columns = Columns(u, v);
                var factor = new CenteredFactor(columns);
                if (factor.Rank > 0)
                {
                    waves.Add(new(frequenciesU[u], frequenciesV[v], u, v, factor, _grid is null ? columns : []));
                }
            }
        }

        _waves = [.. waves];
    }

    /// <summary>Prepares the waves over values.</summary>
    public static WaveBasis Build(FieldData data) => new(data);

    /// <summary>The wave that explains most for its number of functions.</summary>
    /// <param name="values">Values of mean 0 and square sum 1.</param>
    /// <returns>The numbers of waves over the range, and minus the logarithm of the probability that noise explains as much.</returns>
    public (double U, double V, double Score) Strongest(double[] values) => Strongest(values, (_, _) => true);

    /// <summary>The same of some waves.</summary>
    public (double U, double V, double Score) Strongest(double[] values, Func<double, double, bool> isAllowed)
    {
        SumAlongU(values);
        var best = (U: 0.0, V: 0.0, Score: 0.0);
        Span<double> parts = stackalloc double[CenteredFactor.Most];
        foreach (var wave in _waves)
        {
            if (!isAllowed(wave.U, wave.V))
            {
                continue;
            }

            // Sums wait for their own additions, so two columns take the time of one.
            for (var k = 0; k < parts.Length; k += 2)
            {
                (parts[k], parts[k + 1]) = _grid is null
                    ? Vectors.Dots(values, wave.Columns[k], wave.Columns[k + 1])
                    : Vectors.Dots(_alongV[(2 * wave.NumberV) + (k / 2)], _sums[2 * wave.NumberU], _sums[(2 * wave.NumberU) + 1]);
            }

            var score = Score(wave.Factor.Share(parts), wave.Factor.Rank);
            best = score > best.Score ? (wave.U, wave.V, score) : best;
        }

        return best;
    }

    // The four functions of a wave at each value.
    private double[][] Columns(int u, int v)
    {
        double[][] columns = [new double[_count], new double[_count], new double[_count], new double[_count]];
        for (var k = 0; k < _count; k++)
        {
            var (i, j, at) = _grid is null ? (k, k, k) : (k / _grid.V.Length, k % _grid.V.Length, _grid.Index[k]);
            var (cosU, sinU, cosV, sinV) = (_alongU[2 * u][i], _alongU[(2 * u) + 1][i], _alongV[2 * v][j], _alongV[(2 * v) + 1][j]);
            (columns[0][at], columns[1][at], columns[2][at], columns[3][at]) = (cosU * cosV, sinU * cosV, cosU * sinV, sinU * sinV);
        }

        return columns;
    }

    private void SumAlongU(double[] values)
    {
        if (_grid is null)
        {
            return;
        }

        for (var k = 0; k < _values.Length; k++)
        {
            _values[k] = values[_grid.Index[k]];
        }

        var width = _grid.V.Length;
        for (var f = 0; f < _sums.Length; f++)
        {
            Array.Clear(_sums[f]);
            for (var i = 0; i < _grid.U.Length; i++)
            {
                Vectors.Subtract(_sums[f], -_alongU[f][i], _values.AsSpan(i * width, width));
            }
        }
    }

    /// <summary>The share of k of n - 1 directions has a beta distribution with k/2 and (n - 1 - k)/2, whose tail is elementary for even k;
    /// an odd k is taken for the next even one.</summary>
    private double Score(double share, int functions)
    {
        var left = Math.Max(1 - share, 1e-15);
        var pairs = (functions + 1) / 2;
        var half = ((_count - 1) / 2.0) - pairs;
        return -(half * Elementary.Log(left)) - (pairs > 1 ? Elementary.Log(1 + (half * share)) : 0);
    }

    private static double[] Frequencies(int places)
    {
        // From none to half the places less one, in halves: the range has one space less than places.
        var most = Math.Max(0, places - 1);
        return most <= MostFrequencies
            ? [.. Enumerable.Range(0, most + 1).Select(k => k / 2.0)]
            : [.. Enumerable.Range(0, MostFrequencies + 1).Select(k => (double)((long)k * most / MostFrequencies) / 2)];
    }

    private static double[][] Functions(double[] places, double[] frequencies)
    {
        var result = new double[2 * frequencies.Length][];
        for (var f = 0; f < frequencies.Length; f++)
        {
            var turns = Math.PI * frequencies[f];
            result[2 * f] = Array.ConvertAll(places, x => Elementary.Cos(turns * x));
            result[(2 * f) + 1] = Array.ConvertAll(places, x => Elementary.Sin(turns * x));
        }

        return result;
    }

    private sealed record Wave(double U, double V, int NumberU, int NumberV, CenteredFactor Factor, double[][] Columns);
}
