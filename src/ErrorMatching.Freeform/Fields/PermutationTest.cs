namespace ErrorMatching.Freeform;

/// <summary>Several tests of one question, whether values at places are noise, with one error rate.</summary>
/// <remarks>Each test sees another kind of structure: neighbors that are alike or opposite, a plane, a quadratic trend, a wave. All are
/// repeated with the values permuted among the places. The rank of a statistic among its permutations is the probability of that test
/// alone; the rank of the smallest of these probabilities among those of the permutations is the probability with all tests taken
/// together (P. H. Westfall and S. S. Young, Resampling-Based Multiple Testing, 1993, section 2.3: single-step minP). The error rate is
/// therefore that of the level, whatever the distribution of the noise and however much the tests depend on each other.</remarks>
internal sealed class PermutationTest
{
    /// <summary>Number of lines in one direction that suffice to see a structure. More would take time and change nothing.</summary>
    private const int EnoughLines = 30;

    private const ulong Seed = 0x9E3779B97F4A7C15;

    private readonly double[] _values;
    private readonly (int A, int B)[] _neighbors;
    private readonly double[][] _plane;
    private readonly double[][] _quadratic;
    private readonly WaveBasis _waves;

    private PermutationTest(FieldData data)
    {
        var mean = data.Z.Average();
        var length = Math.Sqrt(data.Z.Sum(x => (x - mean) * (x - mean)));
        _values = Array.ConvertAll(data.Z, x => length > 0 ? (x - mean) / length : 0);
        _neighbors = [.. SpatialStructure.Neighbors(data)];
        var (u, v) = (data.U, data.V);
        _plane = OrthonormalColumns.Build([u, v], []);
        _quadratic = OrthonormalColumns.Build([Vectors.Products(u, u), Vectors.Products(u, v), Vectors.Products(v, v)], _plane);
        _waves = WaveBasis.Build(data);
    }

    /// <summary>Tests values, one result for each kind of structure.</summary>
    /// <param name="data">The values; not all equal.</param>
    /// <param name="permutations">Number of permutations.</param>
    public static StructureTest[] Run(FieldData data, int permutations)
    {
        var few = data.Thinned(EnoughLines);
        // The order of the values must not change the permutations of the places.
        int[] order = [.. Enumerable.Range(0, few.Count).OrderBy(k => few.J[k]).ThenBy(k => few.I[k]).ThenBy(k => k)];
        return new PermutationTest(few.Only(order)).Permute(permutations);
    }

    private StructureTest[] Permute(int count)
    {
        // One row for each test; column 0 is of the values as they are.
        var statistics = Array.ConvertAll(new double[4][], _ => new double[count + 1]);
        var values = (double[])_values.Clone();
        var state = Seed;
        for (var k = 0; k <= count; k++)
        {
            var plane = Energy(_plane, values);
            statistics[0][k] = Math.Abs(Alike(values));
            statistics[1][k] = plane;
            statistics[2][k] = plane + Energy(_quadratic, values);
            statistics[3][k] = _waves.Strongest(values).Score;
            Shuffle(values, ref state);
        }

        var alone = Array.ConvertAll(statistics, Ranks);
        var least = new double[count + 1];
        for (var k = 0; k <= count; k++)
        {
            least[k] = alone.Min(p => p[k]);
        }

        var wave = _waves.Strongest(_values);
        double Together(int test) => least.Count(p => p <= alone[test][0]) / (count + 1.0);
        return
        [
            new(StructureKind.Neighbors, Together(0)) { IsOpposite = Alike(_values) < 0 },
            new(StructureKind.Plane, Together(1)),
            new(StructureKind.Quadratic, Together(2)),
            new(StructureKind.Wave, Together(3)) { Waves = (wave.U, wave.V) },
        ];
    }

    /// <summary>The sum of products of neighbors less its expectation: Moran's I but for its factor. The expectation under permutation is
    /// minus the number of pairs divided by n (n - 1), because the values have mean 0 and square sum 1.</summary>
    private double Alike(double[] values)
    {
        var sum = _neighbors.Length / (values.Length * (values.Length - 1.0));
        foreach (var (a, b) in _neighbors)
        {
            sum += values[a] * values[b];
        }

        return sum;
    }

    private static double Energy(double[][] columns, double[] values)
    {
        var sum = 0.0;
        foreach (var column in columns)
        {
            var part = Vectors.Dot(column, values);
            sum += part * part;
        }

        return sum;
    }

    /// <summary>The share of all permutations whose statistic is at least as large.</summary>
    private static double[] Ranks(double[] statistics)
    {
        var sorted = (double[])statistics.Clone();
        Array.Sort(sorted);
        return Array.ConvertAll(statistics, value =>
        {
            // Sums in another order round differently; equal statistics must stay equal.
            var least = value * (1 - 1e-12);
            var at = Array.BinarySearch(sorted, least);
            at = at < 0 ? ~at : at;
            while (at > 0 && sorted[at - 1] >= least)
            {
                at--;
            }

            return (double)(sorted.Length - at) / sorted.Length;
        });
    }

    /// <summary>Fisher and Yates' shuffle with the numbers of SplitMix64 (Steele, Lea and Flood, 2014).</summary>
    private static void Shuffle(double[] values, ref ulong state)
    {
        for (var k = values.Length - 1; k > 0; k--)
        {
            state += 0x9E3779B97F4A7C15;
            var z = state;
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
            z ^= z >> 31;
            var other = (int)(((UInt128)z * (ulong)(k + 1)) >> 64);
            (values[k], values[other]) = (values[other], values[k]);
        }
    }
}
