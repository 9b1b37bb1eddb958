using BenchmarkDotNet.Attributes;
using ErrorMatching.Freeform;

namespace ErrorMatching.Benchmarks;

/// <summary>The fit <c>best</c> in a warm process: goals 100 ms for 70 points, 2 s for 5,000.</summary>
[MemoryDiagnoser]
[SimpleJob(warmupCount: 3, iterationCount: 7)]
public class SurfaceFitBenchmarks
{
    private PointGrid _grid = new([]);

    [ParamsSource(nameof(Shapes))]
    public string Shape { get; set; } = "";

    [Params(70, 5000)]
    public int Points { get; set; }

    [Params(0, 1)]
    public double NoiseUm { get; set; }

    public static IEnumerable<string> Shapes => FitShape.Names;

    [GlobalSetup]
    public void Setup() => _grid = FitShape.Grid(Shape, Points, NoiseUm);

    [Benchmark]
    public FittedSurface Best() => SurfaceFitter.Fit(_grid, FitMethod.Best, JobFit.Default.CurveToleranceMm);
}
