namespace ErrorMatching.Freeform;

/// <summary>Waves over values at places: the products of cosine and sine along u and along v, for a grid of frequencies.</summary>
/// <remarks>A Lomb-Scargle periodogram in two directions (J. D. Scargle, Astrophysical Journal 263, 1982): for each pair of frequencies the
/// share of the variance that its functions explain. Half waves over the range are the longest, two spacings are the shortest.</remarks>
internal sealed class WaveBasis
{
    /// <summary>Largest number of frequencies along one direction.</summary>
    private const int MostFrequencies = 9;

    private readonly (double U, double V, double[][] Columns)[] _waves;
    private readonly int _count;

    private WaveBasis((double U, double V, double[][] Columns)[] waves, int count) => (_waves, _count) = (waves, count);

    /// <summary>Prepares the waves over values.</summary>
    public static WaveBasis Of(FieldData data)
    {
        var (u, v) = (data.U, data.V);
        var waves = new List<(double U, double V, double[][] Columns)>();
        foreach (var waveU in Frequencies(data.Crossings.Length))
        {
            var (cosU, sinU) = Wave(u, waveU);
            foreach (var waveV in Frequencies(data.Curves.Length))
            {
                var (cosV, sinV) = Wave(v, waveV);
                var columns = OrthonormalColumns.Of(
                    [
                        Vectors.Products(cosU, cosV), Vectors.Products(sinU, cosV), Vectors.Products(cosU, sinV),
                        Vectors.Products(sinU, sinV),
                    ],
                    []);
                if (columns.Length > 0)
                {
                    waves.Add((waveU, waveV, columns));
                }
            }
        }

        return new([.. waves], u.Length);
    }

    /// <summary>The wave that explains most for its number of functions.</summary>
    /// <param name="values">Values of mean 0 and square sum 1.</param>
    /// <returns>The numbers of waves over the range, and minus the logarithm of the probability that noise explains as much.</returns>
    public (double U, double V, double Score) Strongest(double[] values) => Strongest(values, (_, _) => true);

    /// <summary>The same of some waves.</summary>
    public (double U, double V, double Score) Strongest(double[] values, Func<double, double, bool> isAllowed)
    {
        var best = (U: 0.0, V: 0.0, Score: 0.0);
        foreach (var (u, v, columns) in _waves)
        {
            if (!isAllowed(u, v))
            {
                continue;
            }

            var share = 0.0;
            // Sums wait for their own additions, so two columns take the time of one.
            var k = 0;
            for (; k + 1 < columns.Length; k += 2)
            {
                var (part, next) = Vectors.Dots(values, columns[k], columns[k + 1]);
                share += part * part;
                share += next * next;
            }

            if (k < columns.Length)
            {
                var part = Vectors.Dot(columns[k], values);
                share += part * part;
            }

            var score = Score(share, columns.Length);
            best = score > best.Score ? (u, v, score) : best;
        }

        return best;
    }

    /// <summary>The share of k of n - 1 directions has a beta distribution with k/2 and (n - 1 - k)/2, whose tail is elementary for even k;
    /// an odd k is taken for the next even one.</summary>
    private double Score(double share, int functions)
    {
        var left = Math.Max(1 - share, 1e-15);
        var pairs = (functions + 1) / 2;
        var half = ((_count - 1) / 2.0) - pairs;
        return -(half * Math.Log(left)) - (pairs > 1 ? Math.Log(1 + (half * share)) : 0);
    }

    private static double[] Frequencies(int places)
    {
        // From none to half the places less one, in halves: the range has one space less than places.
        var most = Math.Max(0, places - 1);
        return most <= MostFrequencies
            ? [.. Enumerable.Range(0, most + 1).Select(k => k / 2.0)]
            : [.. Enumerable.Range(0, MostFrequencies + 1).Select(k => (double)((long)k * most / MostFrequencies) / 2)];
    }

    private static (double[] Cos, double[] Sin) Wave(double[] t, double waves) => (
        Array.ConvertAll(t, x => Math.Cos(Math.PI * waves * x)), Array.ConvertAll(t, x => Math.Sin(Math.PI * waves * x)));
}
