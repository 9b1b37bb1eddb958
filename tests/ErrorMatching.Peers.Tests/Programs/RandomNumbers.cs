namespace ErrorMatching.Peers.Tests;

/// <summary>SplitMix64: the same numbers everywhere.</summary>
internal sealed class RandomNumbers(ulong seed)
{
    private ulong _state = seed;

    public bool Chance(double part) => Uniform(0, 1) < part;

    public int Below(int count) => (int)(Uniform(0, 1) * count);

    public double Uniform(double low, double high)
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return low + ((high - low) * Math.ScaleB((mixed ^ (mixed >> 31)) >> 11, -53));
    }
}
