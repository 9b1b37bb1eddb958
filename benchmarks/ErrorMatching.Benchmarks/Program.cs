using BenchmarkDotNet.Running;
using ErrorMatching.Benchmarks;

if (args is ["whole-process", .. var rest])
{
    return WholeProcess.Run(rest.FirstOrDefault());
}

if (args is ["rs274", .. var blocks])
{
    return PeerBenchmark.Run(blocks.FirstOrDefault());
}

BenchmarkSwitcher.FromAssembly(typeof(MatchBenchmarks).Assembly).Run(args);
return 0;
