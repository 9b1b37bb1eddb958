namespace ErrorMatching.Freeform.Tests;

/// <summary>Normally distributed numbers, the same on every run and platform (SplitMix64 and the polar method's cosine).</summary>
internal sealed class Gaussian(int seed)
{
    private ulong _state = (ulong)seed * 0x9E3779B97F4A7C15UL;

    /// <summary>The next number of mean 0 and standard deviation 1.</summary>
    public double Next() => Math.Sqrt(-2 * Math.Log(1 - Uniform())) * Math.Cos(2 * Math.PI * Uniform());

    private double Uniform()
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return ((mixed ^ (mixed >> 31)) >> 11) * Math.ScaleB(1, -53);
    }
}
