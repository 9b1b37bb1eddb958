using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Numbers of the standard normal distribution, the same for the same seed on every system.</summary>
/// <remarks>Two at a time from two equally distributed ones (G. E. P. Box and M. E. Muller, 1958), which SplitMix64 gives (Steele, Lea and
/// Flood, 2014).</remarks>
internal sealed class NormalVariates(ulong seed)
{
    private ulong _state = seed;
    private double? _second;

    /// <summary>The next number.</summary>
    public double Next()
    {
        if (_second is { } second)
        {
            _second = null;
            return second;
        }

        var (radius, (sine, cosine)) = (Math.Sqrt(-2 * Elementary.Log(Uniform())), Elementary.SinCos(2 * Math.PI * Uniform()));
        _second = radius * sine;
        return radius * cosine;
    }

    // Between 0 and 1, neither of them.
    private double Uniform()
    {
        _state += 0x9E3779B97F4A7C15;
        var z = _state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return (((z ^ (z >> 31)) >> 11) + 0.5) / (1UL << 53);
    }
}
