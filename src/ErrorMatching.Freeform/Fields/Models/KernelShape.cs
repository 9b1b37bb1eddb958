using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A family of kernels: how a vector of parameters becomes one, and where a search starts.</summary>
/// <param name="Constant">The constant of both directions, 0 or 1.</param>
/// <param name="IsWave">True if the kernel has a wave.</param>
internal sealed record KernelShape(double Constant, bool IsWave)
{
    // Highest frequency as a share of one wave in two spaces. Just below that, the values see little of a wave, and noise makes it high.
    private const double Shortest = 0.9;

    /// <summary>A function of both directions.</summary>
    public static KernelShape Smooth { get; } = new(0, false);

    /// <summary>A sum of functions of each direction, a product of waves, and a sum of waves.</summary>
    public static IReadOnlyList<KernelShape> Others { get; } = [new(1, false), new(0, true), new(1, true)];

    /// <summary>Number of parameters more than those of a smooth kernel.</summary>
    public int MoreParameters => IsWave ? 2 : 0;

    /// <summary>The kernel of parameters: the logarithms of both lengths, the decimal logarithm of the noise, and of a wave both angular
    /// frequencies. A wave shorter than two spaces of the lines would look like a longer one.</summary>
    public Kernel Of(double[] x, FieldData data) => new(
        Elementary.Exp(Math.Clamp(x[0], -3, 3)),
        Elementary.Exp(Math.Clamp(x[1], -3, 3)),
        Elementary.Pow(10, Math.Clamp(x[2], -13, 2)),
        Constant,
        IsWave ? Wave(x[3], data.Crossings) : 0,
        IsWave ? Wave(x[4], data.Curves) : 0);

    /// <summary>Parameters from which a search for the likeliest kernel starts.</summary>
    public IEnumerable<double[]> Starts(ProcessTrend trend)
    {
        if (IsWave && trend.Waves is not { Length: > 0 })
        {
            yield break;
        }

        double[] lengths = IsWave ? [0.8, 3] : [0.3, 0.8, 2];
        double[] noises = IsWave ? [-6, -1] : [-10, -4, -1];
        foreach (var length in lengths)
        {
            foreach (var noise in noises)
            {
                double[] smooth = [Elementary.Log(length), Elementary.Log(length), noise];
                if (!IsWave)
                {
                    yield return smooth;
                    continue;
                }

                foreach (var (u, v) in trend.Waves)
                {
                    yield return [.. smooth, Math.PI * u, Math.PI * v];
                }
            }
        }
    }

    private static double Wave(double frequency, int[][] lines) =>
        Math.Min(Math.Abs(frequency), Shortest * Math.PI * (lines.Length - 1) / 2);
}
