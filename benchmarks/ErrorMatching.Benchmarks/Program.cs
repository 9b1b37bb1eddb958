using BenchmarkDotNet.Running;
using ErrorMatching.Benchmarks;

if (args is ["whole-process", ..])
{
    return WholeProcess.Run();
}

BenchmarkSwitcher.FromAssembly(typeof(MatchBenchmarks).Assembly).Run(args);
return 0;
