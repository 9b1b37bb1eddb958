using BenchmarkDotNet.Attributes;
using ErrorMatching.Geometry;

namespace ErrorMatching.Benchmarks;

/// <summary>Polynomial fits of typical sizes, and a large one.</summary>
[MemoryDiagnoser]
public class FitBenchmarks
{
    private double[] _x = [];
    private double[] _y = [];

    [Params(14, 82, 1000)]
    public int Points { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        var random = new Random(1);
        _x = [.. Enumerable.Range(0, Points).Select(i => 5.0 * i)];
        _y = [.. _x.Select(v => Math.Sin(v / 40) + (0.002 * random.NextDouble()))];
    }

    [Benchmark]
    public PolynomialFit DegreeFive() => PolynomialFit.Fit(_x, _y, new() { Degree = 5, Ridge = 0 });

    [Benchmark]
    public PolynomialFit DegreeAndRidgeChosen() => PolynomialFit.Fit(_x, _y, new() { Degree = null, Ridge = null });
}
