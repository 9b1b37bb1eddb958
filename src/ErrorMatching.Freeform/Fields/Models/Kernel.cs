namespace ErrorMatching.Freeform;

/// <summary>How alike the values of two places are: exp(-(du / LengthU)^2 / 2 - (dv / LengthV)^2 / 2), and the variance of noise as a share of the variance of the process.</summary>
internal readonly record struct Kernel(double LengthU, double LengthV, double Noise)
{
    /// <summary>What keeps a matrix of the kernel invertible in double precision.</summary>
    public const double LeastNoise = 1e-13;

    public double AlongU(double a, double b) => Along((a - b) / LengthU);

    public double AlongV(double a, double b) => Along((a - b) / LengthV);

    private static double Along(double x) => Math.Exp(-0.5 * x * x);
}
