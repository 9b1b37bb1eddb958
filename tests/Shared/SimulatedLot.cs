namespace ErrorMatching.Testing;

/// <summary>A lot whose truth is known: 100 pieces with one measured value each, in micrometers.</summary>
internal sealed class SimulatedLot
{
    /// <summary>Standard uncertainty of a value.</summary>
    public const double U = 3;

    public const int Pieces = 100;

    private SimulatedLot(string kind, int seed)
    {
        var random = new Random(seed);
        var (error, drift, walk) = (0.0, 0.0, 0.0);
        switch (kind)
        {
            case "repeating":
                error = random.Next(2) == 0 ? 3 * U : -3 * U;
                break;
            case "drift":
                (error, drift) = (2 * U, U / 10);
                break;
            case "walk":
                (error, walk) = (2 * U * Normal(random), 0.3 * U);
                break;
            case "step":
                StepAt = random.Next(30, 70);
                break;
            case "outliers":
                error = 3 * U;
                break;
            case "noise":
                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(kind), kind, "Unknown kind.");
        }

        (Start, Drift, Walk) = (error, drift, walk);
        for (var k = 0; k < Pieces; k++)
        {
            error += k == StepAt ? 10 : 0;
            IsOutlier[k] = kind == "outliers" && k > 0 && random.NextDouble() < 0.03;
            Shown[k] = error + (U * Normal(random)) + (IsOutlier[k] ? 10 * U * (random.Next(2) == 0 ? 1 : -1) : 0);
            error += drift + (walk * Normal(random));
        }
    }

    public double Start { get; }

    public double Drift { get; }

    public double Walk { get; }

    /// <summary>The piece before which the process moves by 10 um; -1 for none.</summary>
    public int StepAt { get; } = -1;

    public bool[] IsOutlier { get; } = new bool[Pieces];

    /// <summary>What each piece would show without corrections.</summary>
    public double[] Shown { get; } = new double[Pieces];

    public static IEnumerable<SimulatedLot> Many(string kind, int count) =>
        Enumerable.Range(0, count).Select(seed => new SimulatedLot(kind, 1000 + seed));

    /// <summary>What a filter expects that knows all but the noise: the variances, the piece of the step, the outliers.</summary>
    /// <param name="delay">Number of pieces that are cut before the one before them is measured.</param>
    /// <param name="isMeasured">Whether a piece is measured; null if all are.</param>
    public double[] ExpectedByTruth(int delay = 0, Func<int, bool>? isMeasured = null)
    {
        // The textbook's filter for the state (error, drift), in matrices written out.
        var expected = new double[Pieces];
        double x = 0, d = 0, xx = Start * Start, xd = 0, dd = Drift * Drift;
        for (var k = 0; k < Pieces; k++)
        {
            if (k == 0)
            {
                Array.Fill(expected, x, 0, delay + 1);
            }

            xx += k == StepAt ? 100 : 0;
            if (!IsOutlier[k] && isMeasured?.Invoke(k) != false)
            {
                var (s, off) = (xx + (U * U), Shown[k] - x);
                var (gx, gd) = (xx / s, xd / s);
                (x, d) = (x + (gx * off), d + (gd * off));
                (xx, xd, dd) = (xx * (1 - gx), xd * (1 - gx), dd - (gd * xd));
            }

            x += d;
            if (k + 1 + delay < Pieces)
            {
                expected[k + 1 + delay] = x + (delay * d);
            }

            (xx, xd) = (xx + (2 * xd) + dd + (Walk * Walk), xd + dd);
        }

        return expected;
    }

    /// <summary>Sum of the squared errors of the pieces that are no outliers, if what was expected is corrected.</summary>
    public double Cost(IReadOnlyList<double> expected) =>
        Enumerable.Range(0, Pieces).Sum(k => IsOutlier[k] ? 0 : Math.Pow(Shown[k] - expected[k], 2));

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
