using BenchmarkDotNet.Running;
using ErrorMatching.Benchmarks;

if (args is ["whole-process", .. var rest])
{
    return WholeProcess.Run(rest.FirstOrDefault());
}

BenchmarkSwitcher.FromAssembly(typeof(MatchBenchmarks).Assembly).Run(args);
return 0;
