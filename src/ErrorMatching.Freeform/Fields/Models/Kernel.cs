using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The correlation of two places, a product of one function for each direction, and the noise variance as a share of the process
/// variance.</summary>
/// <remarks>The function of a direction is <c>c + exp(-(d / length)^2 / 2) cos(wave d)</c>. Smooth fields have neither constant nor wave.
/// A field that is the sum of a function of u, one of v and one of both has c = 1: (1 + ku) (1 + kv) = 1 + ku + kv + ku kv, of which the
/// polynomial of the process absorbs the 1 (Duvenaud and others, Additive Gaussian Processes, 2011). A wave keeps its length over the
/// surface (Wilson and Adams, Gaussian Process Kernels for Pattern Discovery and Extrapolation, 2013), so that it is known also between
/// points that are a third of it apart.</remarks>
/// <param name="LengthU">Distance along u over which places are alike.</param>
/// <param name="LengthV">The same along v.</param>
/// <param name="Noise">Variance of the noise of one value.</param>
/// <param name="Constant">The constant c of both directions, 0 or 1.</param>
/// <param name="WaveU">Angular frequency along u.</param>
/// <param name="WaveV">Angular frequency along v.</param>
internal readonly record struct Kernel(
    double LengthU, double LengthV, double Noise, double Constant = 0, double WaveU = 0, double WaveV = 0)
{
    /// <summary>The least noise that keeps a kernel matrix invertible in double precision.</summary>
    public const double LeastNoise = 1e-13;

    /// <summary>The kernel of a place with itself.</summary>
    public double AtZero => (1 + Constant) * (1 + Constant);

    public double AlongU(double a, double b) => Along(a - b, (a - b) / LengthU, WaveU);

    public double AlongV(double a, double b) => Along(a - b, (a - b) / LengthV, WaveV);

    private double Along(double distance, double x, double wave) =>
        Constant + (Elementary.Exp(-0.5 * x * x) * (wave == 0 ? 1 : Elementary.Cos(wave * distance)));
}
