namespace ErrorMatching.Freeform.Tests;

/// <summary>Standard normal numbers of a seed (Box and Muller).</summary>
public sealed class Noise(int seed)
{
    private readonly Random _random = new(seed);

    public double Next() => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}
