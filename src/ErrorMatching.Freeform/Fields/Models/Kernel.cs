namespace ErrorMatching.Freeform;

/// <summary>The correlation of two places, exp(-(du / LengthU)^2 / 2 - (dv / LengthV)^2 / 2), and the noise variance as a share of the
/// process variance.</summary>
internal readonly record struct Kernel(double LengthU, double LengthV, double Noise)
{
    /// <summary>The least noise that keeps a kernel matrix invertible in double precision.</summary>
    public const double LeastNoise = 1e-13;

    public double AlongU(double a, double b) => Along((a - b) / LengthU);

    public double AlongV(double a, double b) => Along((a - b) / LengthV);

    private static double Along(double x) => Math.Exp(-0.5 * x * x);
}
